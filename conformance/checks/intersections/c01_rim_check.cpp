#include "conformance/checks/class_check.h"

namespace plumb {

extern const CheckKind c01_rim_check_kind{
    .id = "C1",
    .title = "Rays at the rims of cylinders and cones",
    .asks = "Rays at the rims, from inside and from outside.",
    .matters = "Light leaks at the rim: where side and caps are tested apart, each can hand the ray to the other.",
    .tolerance = kClassTolerance,
    .run = [](Subject& subject, const CheckOptions& options) { return check_family("C1", subject, options); },
};

}  // namespace plumb
