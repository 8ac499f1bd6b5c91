#include <algorithm>

#include "conformance/families/triangles.h"

namespace plumb {
namespace {

FamilyCase far_case(Random& random, const Rounding& rounded) {
  const double offset = random.magnitude(1e3, rounded.pick(1e7, 1e15));
  // At least some dozen steps of the precision out there, so that a triangle stays a triangle.
  const double size = std::max(1.0, 64 * rounded.unit_roundoff() * offset) * random.magnitude(1, 16);
  const Vec3 way = random_direction(random);
  const Vertices triangle = ordinary_triangle(random, rounded, to_point(offset * way), size);
  std::vector<Ray> rays;
  while (rays.size() < kRaysPerCase) {
    const Point3 origin = facing_origin(random, triangle, size, rounded);
    // Seen from the origin, where the target keeps the digits that it would lose so far from zero.
    const Vertices seen{to_point(triangle[0] - origin), to_point(triangle[1] - origin), to_point(triangle[2] - origin)};
    const Ray ray = ray_to({}, any_point(random, seen), rounded);
    rays.push_back({origin, ray.direction});
  }
  return triangle_case(triangle, std::move(rays), rounded);
}

}  // namespace

extern const FamilyKind t07_far_kind{
    .id = "T7",
    .name = "far",
    .recipe = "triangle and origin together 1e3 to 1e7 away from zero (double: to 1e15)",
    .mistake = "products of coordinates instead of differences cancel",
    .make = [](std::uint64_t seed, plumb_precision precision) { return family_of("T7", far_case, seed, precision); },
};

}  // namespace plumb
