#include <algorithm>
#include <array>

#include "meshes/triangle_mesh.h"
#include "renderer/math/support.h"
#include "renderer/surfaces/closest_triangle.h"

namespace plumb {
namespace {

class Mesh : public Surface {
 public:
  Mesh(std::shared_ptr<const TriangleMesh> mesh, Accel accel)
      : mesh_(std::move(mesh)), accelerator_(accel, triangle_bounds(*mesh_)), runs_(bounds_of_runs(*mesh_)) {
    for (const Bounds3& run : runs_) largest_coordinate_ = std::max(largest_coordinate_, largest_coordinate(run));
  }

  std::optional<SurfaceHit> intersect(const Ray& ray, TraceCounters& counters) const override {
    return intersect_placed(PlacedRay(ray), counters);
  }

  bool blocks(const Ray& ray, TraceCounters& counters) const override {
    return blocks_placed(PlacedRay(ray), counters);
  }

  std::optional<SurfaceHit> intersect_placed(const PlacedRay& ray, TraceCounters& counters) const override {
    ClosestTriangle closest(ray, *mesh_, largest_coordinate_);
    Ray rest = ray.object();
    rest.t_max = closest.t_max();
    const auto offer = [&](std::uint32_t triangle) {
      ++counters.primitive_tests;
      closest.offer(triangle);
      rest.t_max = closest.t_max();
      return false;
    };
    accelerator_.walk(rest, counters, offer, ray.drift(largest_coordinate_));
    return closest.result();
  }

  bool blocks_placed(const PlacedRay& ray, TraceCounters& counters) const override {
    const ClosestTriangle triangles(ray, *mesh_, largest_coordinate_);
    const auto meets = [&](std::uint32_t triangle) {
      ++counters.primitive_tests;
      return triangles.meets(triangle);
    };
    return accelerator_.walk(ray.object(), counters, meets, ray.drift(largest_coordinate_));
  }

  std::optional<TriangleVertices> triangle(std::uint32_t part) const override {
    const auto [a, b, c] = mesh_->triangles[part];
    return TriangleVertices{mesh_->positions[a], mesh_->positions[b], mesh_->positions[c]};
  }

  /// Interpolated where the file gives normals, else the triangle's own.
  Normal3 normal(const Ray&, const SurfaceHit& hit) const override {
    const auto [a, b, c] = mesh_->triangles[hit.part];
    if (!mesh_->normals.empty()) {
      const auto& n = mesh_->normals;
      return (1 - hit.u - hit.v) * n[a] + hit.u * n[b] + hit.v * n[c];
    }
    const auto& p = mesh_->positions;
    return as_normal(cross(p[b] - p[a], p[c] - p[a]));
  }

  /// Of the vertices that triangles use.
  Bounds3 world_bounds(const Transform& world_from_object) const override {
    if (mesh_->triangles.empty()) return {};
    return mapped_bounds(world_from_object.matrix(), [&](const AffineRow& row) { return highest_vertex(row); });
  }

 private:
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
      const std::size_t end = std::min((run + 1) * kRun, mesh_->triangles.size());
      for (std::size_t i = run * kRun; i < end; ++i) {
        for (const std::uint32_t vertex : mesh_->triangles[i]) {
          const Point3& p = mesh_->positions[vertex];
          if (!(about_highest(row, {p, p}) <= found)) found = std::max(found, highest(row, p));
        }
      }
    }
    return found;
  }

  std::shared_ptr<const TriangleMesh> mesh_;
  Accelerator accelerator_;
  std::vector<Bounds3> runs_;
  double largest_coordinate_ = 0;
};

constexpr std::array kParameters{
    surface_shader_parameter,
    Parameter{.name = "data",
              .type = ValueType::file,
              .meaning = "a mesh file: .msh, .obj, .ply, .off or .stl, relative to the scene's folder"},
};

std::unique_ptr<Surface> make(const ObjectDescription& object, SurfaceContext& context) {
  return std::make_unique<Mesh>(context.meshes.at(object.file_name("data")), context.accel);
}

}  // namespace

extern const SurfaceKind mesh_kind{
    {Role::surface, "Mesh", "A triangle mesh from a file of its own, shaded with its normals if it has them.",
     kParameters},
    make};

}  // namespace plumb
