#include "conformance/families/triangles.h"

namespace plumb {
namespace {

/// Well-conditioned by construction, so condition stays 1.
FamilyCase control_case(Random& random, const Rounding& rounded) {
  const Vertices triangle = ordinary_triangle(random, rounded);
  std::vector<Ray> rays;
  while (rays.size() < kRaysPerCase) {
    const Point3 origin = facing_origin(random, triangle, 1, rounded);
    const Point3 target = random.coin() ? inner_point(random, triangle) : outer_point(random, triangle);
    rays.push_back(ray_to(origin, target, rounded));
  }
  return triangle_case(triangle, std::move(rays), 1);
}

}  // namespace

extern const FamilyKind t00_control_kind{
    .id = "T0",
    .name = "control",
    .recipe = "ordinary triangles, rays at their inner points or past them by a margin",
    .mistake = "nothing: a program that errs here errs everywhere",
    .make = [](std::uint64_t seed,
               plumb_precision precision) { return family_of("T0", control_case, seed, precision); },
};

}  // namespace plumb
