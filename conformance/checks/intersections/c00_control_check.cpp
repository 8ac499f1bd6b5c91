#include "conformance/checks/class_check.h"

namespace plumb {

extern const CheckKind c00_control_check_kind{
    .id = "C0",
    .title = "Random rays at ordinary cylinders and cones",
    .asks = "Rays at and past ordinary solids of revolution.",
    .matters = "Anything wrong here is wrong everywhere.",
    .tolerance = kClassTolerance,
    .run = [](Subject& subject, const CheckOptions& options) { return check_family("C0", subject, options); },
};

}  // namespace plumb
