#include "conformance/checks/class_check.h"

namespace plumb {

extern const CheckKind s01_far_sphere_check_kind{
    .id = "S1",
    .title = "Spheres far away",
    .asks = "Spheres at 100 to 10^12 radii.",
    .matters = "The discriminant cancels: far spheres are ragged, or larger than they are.",
    .tolerance = kClassTolerance,
    .run = [](Subject& subject, const CheckOptions& options) { return check_family("S1", subject, options); },
};

}  // namespace plumb
