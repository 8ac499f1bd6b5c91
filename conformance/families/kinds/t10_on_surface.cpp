#include "conformance/families/lattice.h"

namespace plumb {
namespace {

Vec3 any_direction(Random& random, const Rounding& rounded) {
  const Vec3 way = random_direction(random);
  return rounded(random.magnitude(0x1p-4, 0x1p4) * way);
}

FamilyCase exact_case(Random& random, const Rounding& rounded) {
  const LatticeTriangle triangle = lattice_triangle(random, random.magnitude(0x1p4, rounded.pick(0x1p18, 0x1p47)));
  std::vector<Ray> rays;
  while (rays.size() < kRaysPerCase) {
    const Point3 origin = random.coin() ? triangle.boundary_point(random) : triangle.inner_point(random);
    rays.push_back({origin, any_direction(random, rounded)});
  }
  return triangle_case(triangle.vertices(), std::move(rays), rounded);
}

FamilyCase on_surface_case(Random& random, const Rounding& rounded) {
  if (random.coin()) return exact_case(random, rounded);
  const Vertices triangle = ordinary_triangle(random, rounded);
  std::vector<Ray> rays;
  while (rays.size() < kRaysPerCase) {
    const Point3 origin = rounded(any_point(random, triangle));
    rays.push_back({origin, any_direction(random, rounded)});
  }
  return triangle_case(triangle, std::move(rays), rounded);
}

}  // namespace

extern const FamilyKind t10_on_surface_kind{
    .id = "T10",
    .name = "on surface",
    .recipe =
        "the origin lies on the triangle: at a vertex, on an edge or inside, exactly (whole numbers) or up to rounding",
    .mistake = "t = 0 is taken by one formula and not by the next",
    .make = [](std::uint64_t seed,
               plumb_precision precision) { return family_of("T10", on_surface_case, seed, precision); },
};

}  // namespace plumb
