#include "meshes/editing/vertex_normals.h"

#include <cmath>
#include <utility>

#include "meshes/editing/face_normal.h"

namespace plumb {

std::size_t compute_normals(TriangleMesh& mesh, NormalWeight weight) {
  const double scale = coordinate_scale(mesh);
  std::vector<Vec3> sums(mesh.positions.size());
  for (const auto& triangle : mesh.triangles) {
    const Vec3 normal = scaled_face_normal(mesh, triangle, scale);
    const double size = length(normal);
    if (!(size > 0)) continue;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t vertex = triangle[corner];
      Vec3 share = normal;
      if (weight == NormalWeight::kAngle) {
        const Vec3 along = scaled_edge(mesh, vertex, triangle[(corner + 1) % 3], scale);
        const Vec3 back = scaled_edge(mesh, vertex, triangle[(corner + 2) % 3], scale);
        share = std::atan2(size, dot(along, back)) * (normal / size);
      }
      sums[vertex] = sums[vertex] + share;
    }
  }
  mesh.normals.assign(mesh.positions.size(), {0, 0, 1});
  std::size_t without = 0;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (length(sums[i]) > 0)
      mesh.normals[i] = as_normal(normalized(sums[i]));
    else
      ++without;
  }
  return without;
}

void flip(TriangleMesh& mesh) {
  for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  for (Normal3& n : mesh.normals) n = -n;
}

}  // namespace plumb
