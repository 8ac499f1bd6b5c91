#include "conformance/families/lattice.h"

namespace plumb {
namespace {

/// Two or three equal vertices, or three on a line.
FamilyCase flat_case(Random& random, const Rounding& rounded, double reach) {
  const Vec3 a = lattice_vector(random, reach);
  const Vec3 step = lattice_vector(random, reach / 8);
  const double second = random.integer(0, 4);
  const double third = random.coin() ? second : random.integer(0, 4);
  Vertices triangle{to_point(a), to_point(a + second * step), to_point(a + third * step)};
  std::swap(triangle[0], triangle[random.below(3)]);
  std::vector<Ray> rays;
  while (rays.size() < kRaysPerCase) {
    const Vec3 origin = lattice_vector(random, reach);
    const Point3 target = to_point(a + random.integer(-1, 5) * step);
    rays.push_back(ray_to(to_point(origin), target, rounded));
  }
  return triangle_case(triangle, std::move(rays), 1);
}

/// The direction is a combination of the edges, so that the determinant is exactly zero; the origin lies in the plane
/// or off it.
FamilyCase edge_on_case(Random& random, const Rounding& rounded, double reach) {
  const LatticeTriangle triangle = lattice_triangle(random, reach);
  std::vector<Ray> rays;
  while (rays.size() < kRaysPerCase) {
    const Vec3 off = random.coin() ? Vec3{} : lattice_vector(random, reach);
    const Point3 from = triangle.near_point(random);
    const Point3 target = triangle.near_point(random) + off;
    rays.push_back(ray_to(from + off, target, rounded));
    if (from + off == target) rays.back().direction = triangle.p;
  }
  return triangle_case(triangle.vertices(), std::move(rays), 1);
}

FamilyCase degenerate_case(Random& random, const Rounding& rounded) {
  const double reach = random.magnitude(0x1p4, rounded.pick(0x1p18, 0x1p47));
  return random.coin() ? flat_case(random, rounded, reach) : edge_on_case(random, rounded, reach);
}

}  // namespace

extern const FamilyKind t11_degenerate_kind{
    .id = "T11",
    .name = "degenerate",
    .recipe = "triangles without area, and rays exactly in or along the plane of a triangle",
    .mistake = "0 / 0 makes NaN, which passes for a hit",
    .make = [](std::uint64_t seed,
               plumb_precision precision) { return family_of("T11", degenerate_case, seed, precision); },
};

}  // namespace plumb
