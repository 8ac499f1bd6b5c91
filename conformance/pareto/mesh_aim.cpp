#include "conformance/pareto/mesh_aim.h"

#include <algorithm>
#include <cmath>

#include "conformance/checks/hit_judge.h"
#include "conformance/families/closed_meshes.h"
#include "conformance/families/triangles.h"
#include "reference/triangle_oracle.h"

namespace plumb {
namespace {

Random random_of(std::string_view where, const std::string& name, MeshAim aim, std::uint64_t seed, std::size_t index) {
  return {seed, std::string(where) + " " + name + " " + std::string(to_string(aim)), index};
}

double half_diagonal(const TriangleMesh& mesh, const Point3& middle) {
  Vec3 reach;
  for (const Point3& p : mesh.positions)
    for (int axis = 0; axis < 3; ++axis) reach[axis] = std::max(reach[axis], std::fabs(p[axis] - middle[axis]));
  return length(reach);
}

}  // namespace

std::string_view to_string(MeshAim aim) {
  return aim == MeshAim::vertices ? "vertices" : aim == MeshAim::edges ? "edges" : "faces";
}

Point3 aimed_point(Random& random, const TriangleMesh& mesh, MeshAim aim) {
  const auto& face = mesh.triangles[random.below(static_cast<std::uint32_t>(mesh.triangles.size()))];
  const Vertices triangle{mesh.positions[face[0]], mesh.positions[face[1]], mesh.positions[face[2]]};
  if (aim == MeshAim::vertices) return triangle[random.below(3)];
  return aim == MeshAim::edges ? edge_point(random, triangle) : inner_point(random, triangle);
}

std::vector<Ray> rays_from_inside(const std::string& name, const TriangleMesh& mesh, MeshAim aim, std::uint64_t seed,
                                  std::size_t count, plumb_precision precision) {
  const Rounding rounded(precision);
  const Point3 middle = middle_of(mesh);
  std::vector<Ray> rays;
  rays.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    Random random = random_of("inside", name, aim, seed, i);
    const double share = random.between(0, 0.7);
    const Point3 origin = rounded(middle + share * (mesh_point(random, mesh) - middle));
    rays.push_back(ray_to(origin, aimed_point(random, mesh, aim), rounded));
  }
  return rays;
}

std::vector<Ray> rays_from_outside(const std::string& name, const TriangleMesh& mesh, MeshAim aim, std::uint64_t seed,
                                   std::size_t count, plumb_precision precision) {
  const Rounding rounded(precision);
  const Point3 middle = middle_of(mesh);
  const double radius = 3 * half_diagonal(mesh, middle);
  std::vector<Ray> rays;
  rays.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    Random random = random_of("outside", name, aim, seed, i);
    const Point3 origin = rounded(middle + radius * random_direction(random));
    rays.push_back(ray_to(origin, aimed_point(random, mesh, aim), rounded));
  }
  return rays;
}

double mesh_margin(const Ray& ray, const TriangleMesh& mesh, std::uint32_t triangle, plumb_precision precision) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return edge_margin(ray, mesh.positions[a], mesh.positions[b], mesh.positions[c], unit_roundoff(precision));
}

}  // namespace plumb
