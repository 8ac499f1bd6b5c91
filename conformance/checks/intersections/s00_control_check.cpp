#include "conformance/checks/class_check.h"

namespace plumb {

extern const CheckKind s00_control_check_kind{
    .id = "S0",
    .title = "Random rays at ordinary spheres",
    .asks = "Rays at and past ordinary spheres.",
    .matters = "Anything wrong here is wrong everywhere.",
    .tolerance = kClassTolerance,
    .run = [](Subject& subject, const CheckOptions& options) { return check_family("S0", subject, options); },
};

}  // namespace plumb
