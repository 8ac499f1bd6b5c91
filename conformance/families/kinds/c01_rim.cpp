#include "conformance/families/solids.h"

namespace plumb {
namespace {

Shape rimmed(Random& random, const Rounding& rounded) {
  switch (random.below(4)) {
    case 0:
      return ordinary_cone(random, rounded);
    case 1:
      return double_cone(random, rounded);
    default:
      return ordinary_cylinder(random, rounded);
  }
}

FamilyCase rim_case(Random& random, const Rounding& rounded) {
  const Shape solid = rimmed(random, rounded);
  std::vector<Ray> rays;
  while (rays.size() < kRaysPerCase) {
    const bool inside = random.coin();
    const Point3 origin = inside ? rounded(inner_point(random, solid)) : outside_origin(random, solid, rounded);
    rays.push_back(ray_to(origin, rim_point(random, solid), rounded));
  }
  return solid_case(solid, std::move(rays), rounded);
}

}  // namespace

extern const FamilyKind c01_rim_kind{
    .id = "C1",
    .name = "rim",
    .recipe = "d = rounded(P - o) with P on a rim of a capped cylinder or cone, from inside and outside",
    .mistake = "side and cap both say that the other is hit, and the ray leaks",
    .make = [](std::uint64_t seed, plumb_precision precision) { return family_of("C1", rim_case, seed, precision); },
};

}  // namespace plumb
