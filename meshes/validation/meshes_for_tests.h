#pragma once

#include <functional>

#include "meshes/triangle_mesh.h"

namespace plumb {

/// The unit cube, corner i at the bits of i (x lowest), front sides outward: 18 edges.
inline TriangleMesh cube() {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) mesh.positions.push_back({double(i & 1), double((i >> 1) & 1), double((i >> 2) & 1)});
  mesh.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
  return mesh;
}

/// The corner of the unit cube at zero, cut off; front sides outward.
inline TriangleMesh tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}, {}, {}};
}

inline TriangleMesh turned_inside_out(TriangleMesh mesh) {
  for (auto& [a, b, c] : mesh.triangles) std::swap(b, c);
  return mesh;
}

inline TriangleMesh mapped(TriangleMesh mesh, const std::function<Point3(const Point3&)>& map) {
  for (Point3& p : mesh.positions) p = map(p);
  return mesh;
}
inline TriangleMesh moved(const TriangleMesh& mesh, const Vec3& by) {
  return mapped(mesh, [&](const Point3& p) { return p + by; });
}
/// By factors along the axes. An odd number of negative ones turns the mesh inside out.
inline TriangleMesh scaled(const TriangleMesh& mesh, const Vec3& by) {
  return mapped(mesh, [&](const Point3& p) { return Point3{by.x * p.x, by.y * p.y, by.z * p.z}; });
}

/// Both, the vertices of the second after those of the first.
inline TriangleMesh joined(TriangleMesh mesh, const TriangleMesh& other) {
  const auto offset = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
  for (const auto& [a, b, c] : other.triangles) mesh.triangles.push_back({a + offset, b + offset, c + offset});
  return mesh;
}

}  // namespace plumb
