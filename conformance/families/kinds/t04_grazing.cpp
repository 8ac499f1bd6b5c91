#include "conformance/families/triangles.h"

namespace plumb {
namespace {

FamilyCase grazing_case(Random& random, const Rounding& rounded) {
  const Vertices triangle = ordinary_triangle(random, rounded);
  const Vec3 n = normalized(normal_of(triangle));
  std::vector<Ray> rays;
  // One angle a case, so that its rays share a condition.
  const double angle = random.magnitude(rounded.pick(1e-7, 1e-16), rounded.pick(1e-2, 1e-6));
  while (rays.size() < kRaysPerCase) {
    const Vec3 along = random_perpendicular(random, n);
    const Vec3 back = (random.sign() * angle) * n - along;
    const Point3 target = any_point(random, triangle);
    const Point3 origin = rounded(target + random.between(1.5, 4) * back);
    rays.push_back(ray_to(origin, target, rounded));
  }
  return triangle_case(triangle, std::move(rays), rounded);
}

}  // namespace

extern const FamilyKind t04_grazing_kind{
    .id = "T4",
    .name = "grazing",
    .recipe = "the ray makes an angle of 1e-7 to 1e-2 with the plane (double: 1e-16 to 1e-6)",
    .mistake = "the class near the edges, and t by up to a million ulp",
    .make = [](std::uint64_t seed,
               plumb_precision precision) { return family_of("T4", grazing_case, seed, precision); },
};

}  // namespace plumb
