#include <algorithm>
#include <array>

#include "meshes/triangle_mesh.h"
#include "renderer/accel/triangle_search.h"
#include "renderer/math/support.h"
#include "renderer/surfaces/surface.h"

namespace plumb {
namespace {

class Mesh : public Surface {
 public:
  explicit Mesh(std::shared_ptr<const TriangleSearch> triangles)
      : triangles_(std::move(triangles)), runs_(bounds_of_runs(triangles_->mesh())) {}

  std::optional<SurfaceHit> intersect(const Ray& ray, TraceCounters& counters) const override {
    return triangles_->closest(PlacedRay(ray), counters);
  }

  bool blocks(const Ray& ray, TraceCounters& counters) const override {
    return triangles_->any(PlacedRay(ray), counters);
  }

  std::optional<SurfaceHit> intersect_placed(const PlacedRay& ray, TraceCounters& counters) const override {
    return triangles_->closest(ray, counters);
  }

  bool blocks_placed(const PlacedRay& ray, TraceCounters& counters) const override {
    return triangles_->any(ray, counters);
  }

  std::optional<TriangleVertices> triangle(std::uint32_t part) const override {
    const auto [a, b, c] = mesh().triangles[part];
    return TriangleVertices{mesh().positions[a], mesh().positions[b], mesh().positions[c]};
  }

  /// Interpolated where the file gives normals, else the triangle's own.
  Normal3 normal(const Ray&, const SurfaceHit& hit) const override {
    const auto [a, b, c] = mesh().triangles[hit.part];
    if (!mesh().normals.empty()) {
      const auto& n = mesh().normals;
      return (1 - hit.u - hit.v) * n[a] + hit.u * n[b] + hit.v * n[c];
    }
    const auto& p = mesh().positions;
    return as_normal(cross(p[b] - p[a], p[c] - p[a]));
  }

  /// Of the vertices that triangles use.
  Bounds3 world_bounds(const Transform& world_from_object) const override {
    if (mesh().triangles.empty()) return {};
    return mapped_bounds(world_from_object.matrix(), [&](const AffineRow& row) { return highest_vertex(row); });
  }

 private:
  const TriangleMesh& mesh() const { return triangles_->mesh(); }

  /// As many triangles share a box, so that finding the highest vertex looks at few of them.
  static constexpr std::size_t kRun = 64;

  static std::vector<Bounds3> bounds_of_runs(const TriangleMesh& mesh) {
    std::vector<Bounds3> runs((mesh.triangles.size() + kRun - 1) / kRun);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
      for (const std::uint32_t vertex : mesh.triangles[i]) runs[i / kRun].extend(mesh.positions[vertex]);
    return runs;
  }

  double highest_vertex(const AffineRow& row) const {
    double found = -Bounds3::kInfinity;
    for (std::size_t run = 0; run < runs_.size(); ++run) {
      if (about_highest(row, runs_[run]) <= found) continue;
      const std::size_t end = std::min((run + 1) * kRun, mesh().triangles.size());
      for (std::size_t i = run * kRun; i < end; ++i) {
        for (const std::uint32_t vertex : mesh().triangles[i]) {
          const Point3& p = mesh().positions[vertex];
          if (!(about_highest(row, {p, p}) <= found)) found = std::max(found, highest(row, p));
        }
      }
    }
    return found;
  }

  std::shared_ptr<const TriangleSearch> triangles_;
  std::vector<Bounds3> runs_;
};

constexpr std::array kParameters{
    surface_shader_parameter,
    Parameter{.name = "data",
              .type = ValueType::file,
              .meaning = "a mesh file: .msh, .obj, .ply, .off or .stl, relative to the scene's folder"},
};

std::unique_ptr<Surface> make(const ObjectDescription& object, SurfaceContext& context) {
  const auto& mesh = context.meshes.at(object.file_name("data"));
  std::shared_ptr<const TriangleSearch>& triangles = context.searches[mesh.get()];
  if (!triangles) triangles = std::make_shared<const TriangleSearch>(mesh, context.accel, context.threads);
  return std::make_unique<Mesh>(triangles);
}

}  // namespace

extern const SurfaceKind mesh_kind{
    {Role::surface, "Mesh", "A triangle mesh from a file of its own, shaded with its normals if it has them.",
     kParameters},
    make};

}  // namespace plumb
