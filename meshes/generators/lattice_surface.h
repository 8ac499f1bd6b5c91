#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "meshes/triangle_mesh.h"

namespace plumb {

/// A solid built of equal cells, the corners of which stand on a lattice.
struct LatticeSolid {
  /// Cells along each axis.
  std::uint32_t cells = 1;
  /// Whether a cell (each index less than `cells`) is filled. Cells that touch in an edge or corner alone would make
  /// a surface that is not manifold.
  std::function<bool(std::uint32_t, std::uint32_t, std::uint32_t)> filled;
  /// The squares of its surface, known beforehand.
  std::uint64_t squares = 6;
  /// In how many parts each cell is cut along each axis: a square across x becomes cuts[1] * cuts[2] rectangles.
  std::array<std::uint32_t, 3> cuts{1, 1, 1};
  /// The lattice's point i along an axis, of n intervals, has the coordinate (2 i - n) / divisors[axis].
  std::array<double, 3> divisors{1, 1, 1};
};

/// The surface between filled and empty cells: two right triangles a rectangle, each lattice point one vertex, no
/// normals. Vertices are numbered as they are met.
TriangleMesh lattice_surface(const LatticeSolid& solid, const std::function<void(double)>& progress);

}  // namespace plumb
