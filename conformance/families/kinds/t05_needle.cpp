#include "conformance/families/triangles.h"

namespace plumb {
namespace {

/// Half of them narrow towards a vertex far away, with the short edge near zero, where it is exact to the last bit; the
/// others have the third vertex beside the middle of a long edge.
Vertices needle(Random& random, const Rounding& rounded) {
  const double long_edge = random.between(1, 10);
  const double width = long_edge / random.magnitude(1e3, rounded.pick(1e7, 1e16));
  const Vec3 along = random_direction(random);
  const Vec3 across = random_perpendicular(random, along);
  const Point3 a = rounded(to_point(width * from_zero(random_point(random, -1, 1))));
  const double share = random.coin() ? 0 : random.between(0.1, 0.9);
  Vertices triangle{a, rounded(a + long_edge * along), rounded(a + (share * long_edge * along + width * across))};
  if (random.coin()) std::swap(triangle[0], triangle[2]);
  return triangle;
}

FamilyCase needle_case(Random& random, const Rounding& rounded) {
  const Vertices triangle = needle(random, rounded);
  std::vector<Ray> rays;
  while (rays.size() < kRaysPerCase) {
    const Point3 target = any_point(random, triangle);
    const Point3 origin = facing_origin(random, triangle, 1, rounded);
    rays.push_back(ray_to(origin, target, rounded));
  }
  return triangle_case(triangle, std::move(rays), rounded);
}

}  // namespace

extern const FamilyKind t05_needle_kind{
    .id = "T5",
    .name = "needle",
    .recipe = "triangles 1e3 to 1e7 times as long as wide (double: to 1e16), rays at their edges, insides and outsides",
    .mistake = "an absolute epsilon on the determinant culls them",
    .make = [](std::uint64_t seed, plumb_precision precision) { return family_of("T5", needle_case, seed, precision); },
};

}  // namespace plumb
