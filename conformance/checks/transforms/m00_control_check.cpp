#include "conformance/checks/class_check.h"

namespace plumb {

extern const CheckKind m00_control_check_kind{
    .id = "M0",
    .title = "Mild nested transforms",
    .asks = "Surfaces in a few ordinary groups.",
    .matters = "Anything wrong here is wrong in every scene with groups.",
    .tolerance = kClassTolerance,
    .run = [](Subject& subject, const CheckOptions& options) { return check_family("M0", subject, options); },
};

}  // namespace plumb
