#include "conformance/families/lattice.h"

namespace plumb {
namespace {

FamilyCase lattice_case(Random& random, const Rounding& rounded) {
  // No coordinate passes 10 reach, so that all differences are exact.
  const double reach = random.magnitude(0x1p4, rounded.pick(0x1p18, 0x1p47));
  const LatticeTriangle triangle = lattice_triangle(random, reach);
  std::vector<Ray> rays;
  while (rays.size() < kRaysPerCase) {
    const Vec3 origin = lattice_vector(random, reach);
    const Point3 target = random.one_in(4) ? triangle.near_point(random) : triangle.boundary_point(random);
    rays.push_back(ray_to(to_point(origin), target, rounded));
  }
  return triangle_case(triangle.vertices(), std::move(rays), rounded);
}

}  // namespace

extern const FamilyKind t03_lattice_kind{
    .id = "T3",
    .name = "lattice",
    .recipe = "vertices and origins are whole numbers and P - o is exact, P on an edge, at a vertex or one step beside",
    .mistake = "u + v <= 1, rounded, loses hits that lie exactly on the boundary",
    .make = [](std::uint64_t seed,
               plumb_precision precision) { return family_of("T3", lattice_case, seed, precision); },
};

}  // namespace plumb
