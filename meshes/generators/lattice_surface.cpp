#include "meshes/generators/lattice_surface.h"

#include <bit>

#include "meshes/generators/progress_steps.h"

namespace plumb {
namespace {

using LatticePoint = std::array<std::uint32_t, 3>;

/// Numbers lattice points as they are first met: a hash table with open addressing.
class LatticeVertices {
 public:
  LatticeVertices(const LatticeSolid& solid, std::size_t most)
      : slots_(std::bit_ceil(2 * most)), shift_(64 - std::countr_zero(slots_.size())), divisors_(solid.divisors) {
    for (std::size_t axis = 0; axis < 3; ++axis) intervals_[axis] = std::uint64_t{solid.cells} * solid.cuts[axis];
    points_.reserve(most);
  }

  std::uint32_t number(const LatticePoint& p) {
    const std::uint64_t key = (p[0] * (intervals_[1] + 1) + p[1]) * (intervals_[2] + 1) + p[2];
    std::size_t slot = (key * 0x9e3779b97f4a7c15u) >> shift_;
    for (; slots_[slot] != 0; slot = (slot + 1) & (slots_.size() - 1))
      if (points_[slots_[slot] - 1] == p) return slots_[slot] - 1;
    points_.push_back(p);
    slots_[slot] = static_cast<std::uint32_t>(points_.size());
    return slots_[slot] - 1;
  }

  std::vector<Point3> positions() const {
    std::vector<Point3> result;
    result.reserve(points_.size());
    for (const LatticePoint& p : points_) result.push_back({along(p, 0), along(p, 1), along(p, 2)});
    return result;
  }

 private:
  double along(const LatticePoint& p, std::size_t axis) const {
    return (2 * static_cast<double>(p[axis]) - static_cast<double>(intervals_[axis])) / divisors_[axis];
  }

  std::vector<std::uint32_t> slots_;  ///< number + 1, or 0
  int shift_;
  std::array<double, 3> divisors_;
  std::array<std::uint64_t, 3> intervals_{};
  std::vector<LatticePoint> points_;
};

/// Adds the rectangles of the square of a cell that looks along an axis, forward or backward.
void add_square(const LatticeSolid& solid, const LatticePoint& cell, std::size_t axis, bool forward,
                LatticeVertices& vertices, TriangleMesh& mesh) {
  // Turning from u to v is counter-clockwise seen from the axis's far end.
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  LatticePoint first;
  for (std::size_t i = 0; i < 3; ++i) first[i] = cell[i] * solid.cuts[i];
  if (forward) first[axis] += solid.cuts[axis];
  for (std::uint32_t i = 0; i < solid.cuts[u]; ++i) {
    for (std::uint32_t j = 0; j < solid.cuts[v]; ++j) {
      const auto corner = [&](std::uint32_t along_u, std::uint32_t along_v) {
        LatticePoint p = first;
        p[u] += i + along_u;
        p[v] += j + along_v;
        return vertices.number(p);
      };
      const std::uint32_t a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
      if (forward) {
        mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
      } else {
        mesh.triangles.insert(mesh.triangles.end(), {{a, c, b}, {a, d, c}});
      }
    }
  }
}

/// Whether the cell's neighbour along an axis is a filled cell.
bool has_neighbour(const LatticeSolid& solid, LatticePoint cell, std::size_t axis, bool forward) {
  if (cell[axis] == (forward ? solid.cells - 1 : 0)) return false;
  forward ? ++cell[axis] : --cell[axis];
  return solid.filled(cell[0], cell[1], cell[2]);
}

}  // namespace

TriangleMesh lattice_surface(const LatticeSolid& solid, const std::function<void(double)>& progress) {
  const auto [x_cuts, y_cuts, z_cuts] = solid.cuts;
  const std::uint64_t rectangles =
      solid.squares / 3 *
      (std::uint64_t{x_cuts} * y_cuts + std::uint64_t{y_cuts} * z_cuts + std::uint64_t{z_cuts} * x_cuts);
  TriangleMesh mesh;
  mesh.triangles.reserve(2 * rectangles);
  LatticeVertices vertices(solid, rectangles + 2);  // by Euler: only a surface of several parts has more

  ProgressSteps steps(progress, solid.squares + 1);
  for (std::uint32_t x = 0; x < solid.cells; ++x) {
    for (std::uint32_t y = 0; y < solid.cells; ++y) {
      for (std::uint32_t z = 0; z < solid.cells; ++z) {
        if (!solid.filled(x, y, z)) continue;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          for (const bool forward : {false, true}) {
            if (has_neighbour(solid, {x, y, z}, axis, forward)) continue;
            add_square(solid, {x, y, z}, axis, forward, vertices, mesh);
            steps.step();
          }
        }
      }
    }
  }
  mesh.positions = vertices.positions();
  steps.step();
  return mesh;
}

}  // namespace plumb
