#include "conformance/checks/class_check.h"

namespace plumb {

extern const CheckKind s02_huge_sphere_check_kind{
    .id = "S2",
    .title = "Huge spheres from just above",
    .asks = "The origin close above a sphere of very large radius.",
    .matters = "The usual ground sphere shows bands and acne: f.f - r^2 cancels.",
    .tolerance = kClassTolerance,
    .run = [](Subject& subject, const CheckOptions& options) { return check_family("S2", subject, options); },
};

}  // namespace plumb
