#include <bit>

#include "meshes/generators/asked_size.h"
#include "meshes/generators/lattice_surface.h"
#include "meshes/generators/mesh_kind.h"

namespace plumb {
namespace {

TriangleMesh make(const MeshRequest& request) {
  const std::uint32_t n = least_size(asked_triangles(request), 1, [](std::uint64_t k) { return 12 * k * k; });
  // Over a power of two all coordinates are exact, in single precision too.
  const double divisor = static_cast<double>(std::bit_ceil(n));
  LatticeSolid cube;
  cube.filled = [](std::uint32_t, std::uint32_t, std::uint32_t) { return true; };
  cube.cuts = {n, n, n};
  cube.divisors = {divisor, divisor, divisor};
  return lattice_surface(cube, request.progress);
}

}  // namespace

extern const MeshKind lattice_cube_kind{"lattice_cube",
                                        "A cube around the origin with faces of equal right triangles, its vertices on "
                                        "a lattice of exact binary fractions.",
                                        true, false, make};

}  // namespace plumb
