#include "conformance/checks/class_check.h"

namespace plumb {

extern const CheckKind s05_b_zero_check_kind{
    .id = "S5",
    .title = "Spheres whose b is zero",
    .asks = "The ray's foot on the centre's plane: b = 0 exactly.",
    .matters = "The stable form divides by zero where the sign of 0 is taken as 0.",
    .tolerance = kClassTolerance,
    .run = [](Subject& subject, const CheckOptions& options) { return check_family("S5", subject, options); },
};

}  // namespace plumb
