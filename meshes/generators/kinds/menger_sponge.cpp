#include "meshes/generators/asked_size.h"
#include "meshes/generators/lattice_surface.h"
#include "meshes/generators/mesh_kind.h"

namespace plumb {
namespace {

/// A cell is drilled away where two of its coordinates have a digit 1 at the same place in base three. No two cells
/// are left that touch in an edge or corner alone: around a lattice point the digits that differ are those below a
/// carry, where 2 and 0 stand and nothing is drilled, and one digit, which is 1 on one side.
bool filled(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  for (; x + y + z > 0; x /= 3, y /= 3, z /= 3)
    if ((x % 3 == 1) + (y % 3 == 1) + (z % 3 == 1) >= 2) return false;
  return true;
}

struct Sponge {
  int level = 1;
  std::uint32_t cells = 3;
  std::uint64_t squares = 72;
};

/// The deepest sponge of level 1 or more whose squares, cut in two, are no more triangles than asked.
Sponge deepest(std::uint64_t asked) {
  Sponge sponge;
  std::uint64_t twenties = 400, eights = 64;
  while (2 * (2 * twenties + 4 * eights) <= asked) {
    sponge = {sponge.level + 1, 3 * sponge.cells, 2 * twenties + 4 * eights};
    twenties *= 20;
    eights *= 8;
  }
  return sponge;
}

TriangleMesh make(const MeshRequest& request) {
  const std::uint64_t asked = asked_triangles(request);
  const Sponge sponge = deepest(asked);
  LatticeSolid solid;
  solid.cells = sponge.cells;
  solid.filled = filled;
  solid.squares = sponge.squares;
  // By symmetry a third of the squares is across each axis. Cutting one axis after the other once more gives small
  // steps.
  const auto triangles = [&] {
    const auto [x, y, z] = solid.cuts;
    return 2 * sponge.squares / 3 * (std::uint64_t{x} * y + std::uint64_t{y} * z + std::uint64_t{z} * x);
  };
  for (std::size_t axis = 0; triangles() < asked; axis = (axis + 1) % 3) ++solid.cuts[axis];
  for (std::size_t axis = 0; axis < 3; ++axis)
    solid.divisors[axis] = static_cast<double>(sponge.cells) * solid.cuts[axis];
  return lattice_surface(solid, request.progress);
}

}  // namespace

extern const MeshKind menger_sponge_kind{
    "menger_sponge", "A cube with square holes through its holes: the surface of a Menger sponge, of high genus.", true,
    false, make};

}  // namespace plumb
