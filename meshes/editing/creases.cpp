#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "meshes/editing/face_normal.h"
#include "meshes/editing/vertex_normals.h"
#include "renderer/math/rotation.h"

namespace plumb {
namespace {

/// Corner `c % 3` of triangle `c / 3` is corner c. Sets of corners that share their vertex.
class CornerSets {
 public:
  explicit CornerSets(std::size_t corners) : parent_(corners) { std::iota(parent_.begin(), parent_.end(), 0); }

  /// The smallest corner of the set.
  std::size_t first_of(std::size_t corner) {
    while (parent_[corner] != corner) corner = parent_[corner] = parent_[parent_[corner]];
    return corner;
  }
  void join(std::size_t a, std::size_t b) {
    a = first_of(a);
    b = first_of(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> parent_;
};

/// One side of a triangle, by its vertices in ascending order.
struct Side {
  std::uint32_t low, high;
  std::size_t low_corner, high_corner;
  friend bool operator<(const Side& a, const Side& b) {
    return a.low != b.low ? a.low < b.low : a.high != b.high ? a.high < b.high : a.low_corner < b.low_corner;
  }
};

std::vector<Side> sorted_sides(const TriangleMesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      const std::uint32_t a = mesh.triangles[i][k], b = mesh.triangles[i][next];
      if (a < b) sides.push_back({a, b, 3 * i + k, 3 * i + next});
      if (b < a) sides.push_back({b, a, 3 * i + next, 3 * i + k});
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

std::uint32_t repeat_vertex(TriangleMesh& mesh, std::uint32_t vertex) {
  if (mesh.positions.size() == std::numeric_limits<std::uint32_t>::max())
    throw std::length_error("split_at_creases: more vertices than a mesh can have");
  const auto repeat = [&](auto& list) {
    const auto value = list[vertex];
    list.push_back(value);
  };
  repeat(mesh.positions);
  if (!mesh.normals.empty()) repeat(mesh.normals);
  if (!mesh.texcoords.empty()) repeat(mesh.texcoords);
  return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

/// The first set of each vertex keeps it, each further one gets a vertex of its own.
void give_each_set_a_vertex(TriangleMesh& mesh, CornerSets& sets) {
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::vector<bool> taken(mesh.positions.size());
  std::vector<std::uint32_t> vertex_of(3 * mesh.triangles.size(), kNone);
  for (std::size_t corner = 0; corner < vertex_of.size(); ++corner) {
    std::uint32_t& vertex = mesh.triangles[corner / 3][corner % 3];
    std::uint32_t& chosen = vertex_of[sets.first_of(corner)];
    if (chosen == kNone) {
      chosen = taken[vertex] ? repeat_vertex(mesh, vertex) : vertex;
      if (chosen == vertex) taken[vertex] = true;
    }
    vertex = chosen;
  }
}

}  // namespace

std::size_t split_at_creases(TriangleMesh& mesh, double degrees) {
  const double cosine = cos_sin_degrees(degrees).cos;
  const double scale = coordinate_scale(mesh);
  const auto is_smooth = [&](std::size_t a, std::size_t b) {
    const Vec3 m = scaled_face_normal(mesh, mesh.triangles[a], scale);
    const Vec3 n = scaled_face_normal(mesh, mesh.triangles[b], scale);
    return dot(m, n) >= cosine * length(m) * length(n);
  };
  const std::vector<Side> sides = sorted_sides(mesh);
  CornerSets sets(3 * mesh.triangles.size());
  for (std::size_t first = 0, end = 0; first < sides.size(); first = end) {
    for (end = first; end < sides.size() && sides[end].low == sides[first].low && sides[end].high == sides[first].high;)
      ++end;
    for (std::size_t i = first; i < end; ++i) {
      for (std::size_t j = i + 1; j < end; ++j) {
        if (!is_smooth(sides[i].low_corner / 3, sides[j].low_corner / 3)) continue;
        sets.join(sides[i].low_corner, sides[j].low_corner);
        sets.join(sides[i].high_corner, sides[j].high_corner);
      }
    }
  }
  const std::size_t before = mesh.positions.size();
  give_each_set_a_vertex(mesh, sets);
  return mesh.positions.size() - before;
}

}  // namespace plumb
