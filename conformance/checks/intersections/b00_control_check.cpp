#include "conformance/checks/class_check.h"

namespace plumb {

extern const CheckKind b00_control_check_kind{
    .id = "B0",
    .title = "Random rays at ordinary boxes",
    .asks = "Rays at and past ordinary boxes.",
    .matters = "Anything wrong here is wrong everywhere.",
    .tolerance = kClassTolerance,
    .run = [](Subject& subject, const CheckOptions& options) { return check_family("B0", subject, options); },
};

}  // namespace plumb
