#include "meshes/editing/face_normal.h"

#include <algorithm>
#include <cmath>

namespace plumb {

double coordinate_scale(const TriangleMesh& mesh) {
  double largest = 0;
  for (const Point3& p : mesh.positions) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  return largest > 0 ? std::ldexp(1, -std::clamp(std::ilogb(largest), -1000, 1000)) : 1;
}

Vec3 scaled_edge(const TriangleMesh& mesh, std::uint32_t from, std::uint32_t to, double scale) {
  const Point3 &p = mesh.positions[from], &q = mesh.positions[to];
  return {q.x * scale - p.x * scale, q.y * scale - p.y * scale, q.z * scale - p.z * scale};
}

Vec3 scaled_face_normal(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& triangle, double scale) {
  const auto& [a, b, c] = triangle;
  return cross(scaled_edge(mesh, a, b, scale), scaled_edge(mesh, a, c, scale));
}

}  // namespace plumb
