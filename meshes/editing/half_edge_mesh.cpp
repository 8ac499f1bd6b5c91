#include "meshes/editing/half_edge_mesh.h"

#include <stdexcept>

#include "meshes/editing/manifold.h"

namespace plumb {

HalfEdgeMesh half_edge_mesh(const TriangleMesh& mesh) {
  if (const auto fault = manifold_fault(mesh)) throw std::invalid_argument("half_edge_mesh: " + *fault);
  // A triangle without neighbours has six half-edges.
  constexpr std::size_t kMost = 0x7fffffff;
  if (mesh.positions.size() > kMost || mesh.triangles.size() > kMost / 6)
    throw std::length_error("half_edge_mesh: more vertices or triangles than OpenMesh counts");
  HalfEdgeMesh result;
  result.reserve(mesh.positions.size(), mesh.triangles.size() * 3 / 2, mesh.triangles.size());
  for (const Point3& p : mesh.positions) result.add_vertex({p.x, p.y, p.z});
  const auto handle = [](std::uint32_t vertex) { return OpenMesh::VertexHandle(static_cast<int>(vertex)); };
  for (const auto& [a, b, c] : mesh.triangles) {
    if (!result.add_face(handle(a), handle(b), handle(c)).is_valid())
      throw std::logic_error("half_edge_mesh: OpenMesh refuses a triangle of a manifold mesh");
  }
  return result;
}

}  // namespace plumb
