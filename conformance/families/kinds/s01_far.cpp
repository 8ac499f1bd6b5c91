#include "conformance/families/solids.h"

namespace plumb {
namespace {

/// Beyond this many radii the rounding of the direction alone moves the ray by a radius, unless it runs along an axis.
bool must_run_along_axis(double radii, const Rounding& rounded) { return radii * 8 * rounded.unit_roundoff() > 1; }

FamilyCase far_sphere_case(Random& random, const Rounding& rounded) {
  const double radius = rounded(random.magnitude(0.1, 10));
  const Point3 center = rounded(to_point(radius * from_zero(random_point(random, -1, 1))));
  const Shape sphere = sphere_of(center, radius);
  const double radii = random.magnitude(1e2, 1e12);
  const bool along_axis = must_run_along_axis(radii, rounded) || random.one_in(4);
  std::vector<Ray> rays;
  while (rays.size() < kRaysPerCase) {
    Vec3 way = random_direction(random);
    const int axis = random.integer(0, 2);
    if (along_axis) way = Vec3{}, way[axis] = random.sign();
    const double past = random.coin() ? random.between(0, 0.9) : random.between(1.1, 2);
    const Point3 target = center + past * radius * random_perpendicular(random, way);
    Point3 origin = rounded(target + radii * radius * way);
    Vec3 direction = ray_to(origin, target, rounded).direction;
    if (along_axis) direction = Vec3{}, direction[axis] = rounded(-way[axis] * random.magnitude(0.1, 10));
    rays.push_back({origin, direction});
  }
  return solid_case(sphere, std::move(rays), rounded);
}

}  // namespace

extern const FamilyKind s01_far_kind{
    .id = "S1",
    .name = "far sphere",
    .recipe = "the origin 1e2 to 1e12 radii away, the rays past the middle by 0 to 0.9 or 1.1 to 2 radii",
    .mistake = "b^2 - a c cancels: hits are lost and made up",
    .make = [](std::uint64_t seed,
               plumb_precision precision) { return family_of("S1", far_sphere_case, seed, precision); },
};

}  // namespace plumb
