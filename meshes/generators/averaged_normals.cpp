#include "meshes/generators/averaged_normals.h"

namespace plumb {
namespace {

Vec3 twice_area(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& t) {
  const Point3& a = mesh.positions[t[0]];
  return cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a);
}

}  // namespace

std::vector<Normal3> averaged_normals(const TriangleMesh& mesh, Normal3 (*sure)(const Point3& position)) {
  std::vector<Normal3> normals(mesh.positions.size());
  for (const auto& triangle : mesh.triangles) {
    const Normal3 face = as_normal(twice_area(mesh, triangle));
    for (const std::uint32_t corner : triangle) normals[corner] = normals[corner] + face;
  }
  for (Normal3& normal : normals) normal = normalized(normal);

  // 0.05 is far enough from 0 that no rounding matters, and within 3 degrees of what can be asked for.
  for (const auto& triangle : mesh.triangles) {
    const Vec3 face = normalized(twice_area(mesh, triangle));
    for (const std::uint32_t corner : triangle) {
      if (!(dot(normals[corner], face) > 0.05)) normals[corner] = sure(mesh.positions[corner]);
    }
  }
  return normals;
}

}  // namespace plumb
