#include "meshes/editing/subdivide.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <unordered_map>

namespace plumb {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// Numbers the midpoints of edges, each edge once whichever of its faces asks first.
class Midpoints {
 public:
  explicit Midpoints(TriangleMesh& mesh) : mesh_(mesh) { of_edge_.reserve(mesh.triangles.size() * 3 / 2); }

  std::uint32_t between(std::uint32_t a, std::uint32_t b) {
    const std::uint64_t edge = (std::uint64_t{std::min(a, b)} << 32) | std::max(a, b);
    const auto [found, is_new] = of_edge_.try_emplace(edge, static_cast<std::uint32_t>(mesh_.positions.size()));
    if (is_new) add(a, b);
    return found->second;
  }

 private:
  void add(std::uint32_t a, std::uint32_t b) {
    if (mesh_.positions.size() == std::numeric_limits<std::uint32_t>::max())
      throw std::length_error("subdivided: more vertices than a mesh can have");
    const auto middle = [&](auto& list) {
      const auto p = list[a], q = list[b];
      list.push_back({p.x / 2 + q.x / 2, p.y / 2 + q.y / 2, p.z / 2 + q.z / 2});
    };
    middle(mesh_.positions);
    if (!mesh_.normals.empty()) middle(mesh_.normals);
    if (mesh_.texcoords.empty()) return;
    const TexCoord p = mesh_.texcoords[a], q = mesh_.texcoords[b];
    mesh_.texcoords.push_back({p.u / 2 + q.u / 2, p.v / 2 + q.v / 2});
  }

  TriangleMesh& mesh_;
  std::unordered_map<std::uint64_t, std::uint32_t> of_edge_;
};

}  // namespace

TriangleMesh subdivided(const TriangleMesh& mesh) {
  if (mesh.triangles.size() > std::numeric_limits<std::uint32_t>::max() / 4)
    throw std::length_error("subdivided: more triangles than a mesh can have");
  TriangleMesh finer = mesh;
  Midpoints midpoints(finer);
  std::vector<Triangle> triangles;
  triangles.reserve(4 * mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::uint32_t ab = midpoints.between(a, b);
    const std::uint32_t bc = midpoints.between(b, c);
    const std::uint32_t ca = midpoints.between(c, a);
    triangles.insert(triangles.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  finer.triangles = std::move(triangles);
  return finer;
}

}  // namespace plumb
