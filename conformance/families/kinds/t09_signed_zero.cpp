#include "conformance/families/triangles.h"

namespace plumb {
namespace {

/// A ray through the target exactly on its zero axes.
Ray zero_ray(Random& random, const Point3& target, const Rounding& rounded) {
  const Vec3 way = random_direction(random);
  Point3 origin = rounded(target + random.between(1.5, 4) * way);
  const int first = random.integer(0, 2);
  const int second = random.coin() ? first : (first + random.integer(1, 2)) % 3;
  for (const int axis : {first, second}) origin[axis] = target[axis];
  Ray ray = ray_to(origin, target, rounded);
  for (const int axis : {first, second}) ray.direction[axis] = 0 * random.sign();
  return ray;
}

FamilyCase signed_zero_case(Random& random, const Rounding& rounded) {
  const Vertices triangle = ordinary_triangle(random, rounded);
  std::vector<Ray> rays;
  while (rays.size() < kRaysPerCase) {
    const Point3 target = rounded(any_point(random, triangle));
    rays.push_back(zero_ray(random, target, rounded));
  }
  return triangle_case(triangle, std::move(rays), rounded);
}

}  // namespace

extern const FamilyKind t09_signed_zero_kind{
    .id = "T9",
    .name = "signed zero",
    .recipe = "one or two components of the direction are +0 or -0",
    .mistake = "the sign of a zero, or 1 / 0, picks the wrong octant of a hierarchy",
    .make = [](std::uint64_t seed,
               plumb_precision precision) { return family_of("T9", signed_zero_case, seed, precision); },
};

}  // namespace plumb
