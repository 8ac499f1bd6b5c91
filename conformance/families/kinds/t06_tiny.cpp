#include "conformance/families/triangles.h"

namespace plumb {
namespace {

FamilyCase tiny_case(Random& random, const Rounding& rounded) {
  const double size = random.magnitude(rounded.pick(1e-6, 1e-12), 2e-4);
  // Near zero its vertices keep all digits; a unit away they lose those that its size is short of.
  const double distance = random.coin() ? 1 : 4 * size;
  const Vec3 way = random_direction(random);
  const Vertices triangle = ordinary_triangle(random, rounded, to_point(distance * way), size);
  // Seen from nearby the direction is tiny too.
  const double from = random.coin() ? 1 : size;
  std::vector<Ray> rays;
  while (rays.size() < kRaysPerCase) {
    const Point3 target = any_point(random, triangle);
    const Point3 origin = facing_origin(random, triangle, from, rounded);
    rays.push_back(ray_to(origin, target, rounded));
  }
  return triangle_case(triangle, std::move(rays), rounded);
}

}  // namespace

extern const FamilyKind t06_tiny_kind{
    .id = "T6",
    .name = "tiny",
    .recipe = "triangles of 2e-4 and smaller (to 1e-6; double: to 1e-12) within reach of the origin",
    .mistake = "the determinant, about the square of the size, falls below an absolute epsilon",
    .make = [](std::uint64_t seed, plumb_precision precision) { return family_of("T6", tiny_case, seed, precision); },
};

}  // namespace plumb
