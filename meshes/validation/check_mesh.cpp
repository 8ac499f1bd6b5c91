#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "meshes/validation/mesh_places.h"
#include "meshes/validation/mesh_report.h"
#include "meshes/validation/mesh_topology.h"
#include "meshes/validation/product_sum.h"
#include "meshes/validation/self_intersections.h"
#include "meshes/validation/triangle_signs.h"

namespace plumb {
namespace {

void check_vertices(const TriangleMesh& mesh, const MeshPlaces& places, MeshReport& report) {
  std::vector<bool> used(mesh.positions.size());
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t vertex : triangle) used[vertex] = true;
  for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) {
    if (used[i])
      report.bounds.extend(mesh.positions[i]);
    else
      report.unused_vertices.add(i);
  }
  for (const std::uint32_t vertex : places.duplicates) report.duplicate_vertices.add(vertex);
  for (const std::uint32_t vertex : places.seams) report.seam_vertices.add(vertex);
  for (std::uint32_t i = 0; i < mesh.normals.size(); ++i) {
    const double off = std::fabs(length(as_vector(mesh.normals[i])) - 1);
    if (!(off <= MeshReport::kUnitTolerance)) report.normals_not_unit.add(i);
  }
}

void check_triangles(const TriangleMesh& mesh, MeshReport& report) {
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    if (a == b || b == c || c == a) {
      report.repeated_corners.add(i);
      continue;
    }
    const Point3 &p = mesh.positions[a], &q = mesh.positions[b], &r = mesh.positions[c];
    if (on_a_line(p, q, r)) {
      report.zero_area.add(i);
      continue;
    }
    if (mesh.normals.empty()) continue;
    for (const std::uint32_t vertex : mesh.triangles[i])
      if (side_of_normal(mesh.normals[vertex], p, q, r) < 0) report.normals_against.add(i);
  }
}

/// Of a closed, oriented mesh, wherever it lies: each triangle makes a tetrahedron with the origin, whose volume is a
/// sixth of a determinant.
int sign_of_volume(const TriangleMesh& mesh) {
  ProductSum volume;
  for (const auto& triangle : mesh.triangles) {
    const Point3 &a = mesh.positions[triangle[0]], &b = mesh.positions[triangle[1]], &c = mesh.positions[triangle[2]];
    for (int axis = 0; axis < 3; ++axis) {
      const int next = (axis + 1) % 3, after = (axis + 2) % 3;
      volume.add(a[axis], b[next], c[after]);
      volume.subtract(a[axis], b[after], c[next]);
    }
  }
  return volume.sign();
}

/// Maps the progress of a part to that of the whole.
std::function<void(double)> part(const MeshChecking& options, double begin, double end) {
  if (!options.progress) return {};
  return [&options, begin, end](double share) { options.progress(begin + share * (end - begin)); };
}

}  // namespace

MeshReport check_mesh(const TriangleMesh& mesh, const MeshChecking& options) {
  if (mesh.triangles.size() >= (std::uint64_t{1} << 32) / 3 || mesh.positions.size() >= std::uint64_t{1} << 32)
    throw std::length_error("the mesh has too many triangles or vertices to be checked");
  const auto tell = [&](double share) {
    if (options.progress) options.progress(share);
  };
  MeshReport report;
  report.vertices = mesh.positions.size();
  report.triangles = mesh.triangles.size();
  report.has_normals = !mesh.normals.empty();
  report.has_texcoords = !mesh.texcoords.empty();
  tell(0);
  const double cheap = options.self_intersections ? 0.4 : 1;
  const MeshPlaces places = mesh_places(mesh);
  tell(0.3 * cheap);
  check_vertices(mesh, places, report);
  check_triangles(mesh, report);
  tell(0.5 * cheap);
  check_topology(mesh, places.place_of, part(options, 0.5 * cheap, 0.9 * cheap), report);
  if (report.closed && report.oriented) report.outward = sign_of_volume(mesh) > 0;
  tell(cheap);
  if (options.self_intersections)
    report.self_intersections = self_intersections(mesh, places.place_of, part(options, cheap, 1));
  tell(1);
  return report;
}

}  // namespace plumb
