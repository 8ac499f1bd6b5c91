#include <algorithm>

#include "conformance/families/solids.h"

namespace plumb {
namespace {

/// As people make a ground: the top at zero, so that origins near it are exact to the last bit; or anywhere.
FamilyCase huge_sphere_case(Random& random, const Rounding& rounded) {
  const double radius = rounded(random.magnitude(1e3, rounded.pick(1e7, 1e12)));
  const bool ground = random.coin();
  const int up_axis = random.integer(0, 2);
  // In the general place the height must be some dozen steps of the precision out there.
  const double least = ground ? 1e-3 : std::max(1e-3, 64 * rounded.unit_roundoff() * radius);
  const double height = random.magnitude(least, 10 * std::max(1.0, least));
  Point3 center = rounded(random_point(random, -2, 2));
  if (ground) center = Point3{}, center[up_axis] = -radius;
  std::vector<Ray> rays;
  while (rays.size() < kRaysPerCase) {
    Vec3 up = random_direction(random);
    if (ground) up = Vec3{}, up[up_axis] = 1;
    const Point3 origin = ground ? rounded(to_point(height * up)) : rounded(center + (radius + height) * up);
    const Vec3 beside = random_perpendicular(random, up);
    const double steepness = random.between(0.2, 1);
    const double downward = random.one_in(4) ? 1 : -1;
    rays.push_back({origin, rounded(downward * steepness * up + (1 - steepness) * beside)});
  }
  const double condition = std::clamp(radius / height, 1.0, rounded.largest_condition());
  return case_of(sphere_of(center, radius), std::move(rays), condition);
}

}  // namespace

extern const FamilyKind s02_huge_kind{
    .id = "S2",
    .name = "huge sphere",
    .recipe = "radius 1e3 to 1e7 (double: to 1e12), the origin 1e-3 to 10 above its surface",
    .mistake = "f.f - r^2 cancels, so t is off by as much as the radius is larger than the height",
    .make = [](std::uint64_t seed,
               plumb_precision precision) { return family_of("S2", huge_sphere_case, seed, precision); },
};

}  // namespace plumb
