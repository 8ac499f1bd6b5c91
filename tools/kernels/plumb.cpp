// Our own tracer: the renderer's surfaces in the renderer's scene, asked as its integrator asks them.
#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <stdexcept>
#include <string>
#include <tuple>

#include "renderer/scene.h"
#include "renderer/surfaces/triangle.h"
#include "tools/kernels/kernel_table.h"

namespace plumb::kernels {
namespace {

/// The file that a mesh is said to come from; meshes with the same arrays are one.
using MeshKey = std::tuple<const double*, const std::uint32_t*, std::size_t, std::size_t>;

TriangleMesh mesh_of(const plumb_mesh& from) {
  TriangleMesh mesh;
  for (std::size_t i = 0; i < from.vertex_count; ++i) {
    const double* p = from.positions + 3 * i;
    mesh.positions.push_back({p[0], p[1], p[2]});
  }
  for (std::size_t i = 0; i < from.triangle_count; ++i) {
    const std::uint32_t* t = from.triangles + 3 * i;
    mesh.triangles.push_back({t[0], t[1], t[2]});
  }
  return mesh;
}

Transform transform_of(const plumb_surface& surface) {
  AffineMatrix matrix;
  for (std::size_t i = 0; i < 12; ++i) matrix[i / 4][i % 4] = surface.world_from_object[i];
  return Transform(matrix);
}

Vec3 vector_of(const double (&p)[3]) { return {p[0], p[1], p[2]}; }

const SurfaceKind& kind_named(std::string_view name) {
  for (const SurfaceKind* kind : surface_kinds())
    if (kind->kind.name == name) return *kind;
  throw std::logic_error("no surface of kind " + std::string(name));
}

/// An element of a scene file, in memory: what the kinds make their surfaces of.
class Element {
 public:
  explicit Element(std::string_view kind) : kind_(kind_named(kind)) { object_.kind = &kind_.kind; }
  Element& with(std::string_view name, Value value) {
    for (const Parameter& parameter : kind_.kind.parameters)
      if (parameter.name == name) object_.properties.push_back({&parameter, std::move(value), {}});
    return *this;
  }
  std::unique_ptr<Surface> make(SurfaceContext& context) const { return kind_.make(object_, context); }

 private:
  const SurfaceKind& kind_;
  ObjectDescription object_;
};

Element element_of(const plumb_surface& surface, const std::string& mesh) {
  switch (surface.kind) {
    case PLUMB_SPHERE:
      return Element("Sphere").with("center", vector_of(surface.center)).with("radius", surface.radius);
    case PLUMB_BOX:
      return Element("Box").with("minPt", vector_of(surface.box_min)).with("maxPt", vector_of(surface.box_max));
    case PLUMB_CYLINDER:
      return Element("Cylinder")
          .with("center", vector_of(surface.center))
          .with("radius", surface.radius)
          .with("height", surface.height);
    case PLUMB_CONE:
      return Element("Cone")
          .with("center", vector_of(surface.center))
          .with("tipz", surface.tip_z)
          .with("radius", surface.radius)
          .with("height", surface.height);
    case PLUMB_MESH:
      return Element("Mesh").with("data", mesh);
    default:
      throw std::invalid_argument("a surface of an unknown kind");
  }
}

/// A renderer's mesh says only which hit is the closest. For all hits its triangles are searched here, with the
/// renderer's test and hierarchy; the hierarchy is made when it is first needed.
class MeshSearch {
 public:
  explicit MeshSearch(std::shared_ptr<const TriangleMesh> mesh) : mesh_(std::move(mesh)) {}

  void all(const PlacedRay& ray, std::uint32_t surface, std::vector<Hit>& hits) {
    std::call_once(made_, [&] {
      const std::vector<Bounds3> bounds = triangle_bounds(*mesh_);
      hierarchy_.emplace(bounds);
      for (const Bounds3& box : bounds) largest_ = std::max(largest_, largest_coordinate(box));
    });
    const ShearedRay sheared(ray);
    TraceCounters counters;
    const auto test = [&](std::uint32_t i) {
      const auto [a, b, c] = mesh_->triangles[i];
      const auto& p = mesh_->positions;
      if (const auto hit = intersect_triangle(sheared, p[a], p[b], p[c]))
        hits.push_back({surface, i, hit->t, hit->u, hit->v});
      return false;
    };
    hierarchy_->walk(ray.object(), counters, test, ray.drift(largest_));
  }

 private:
  std::shared_ptr<const TriangleMesh> mesh_;
  std::once_flag made_;
  std::optional<Hierarchy> hierarchy_;
  double largest_ = 0;
};

class PlumbKernel {
 public:
  explicit PlumbKernel(std::span<const plumb_surface> surfaces) : scene_(contents_of(surfaces), Accel::bvh8) {}

  Hit closest(const Ray& ray) const {
    TraceCounters counters;
    const std::optional<Scene::Hit> hit = scene_.closest_hit(ray, counters);
    if (!hit) return {};
    return hit_of(hit->placed, hit->hit);
  }

  bool any(const Ray& ray) const {
    TraceCounters counters;
    return scene_.blocks(ray, counters);
  }

  void all(const Ray& ray, std::vector<Hit>& hits) const {
    for (std::uint32_t i = 0; i < scene_.placed().size(); ++i) {
      const PlacedSurface& placed = scene_.placed()[i];
      const PlacedRay own(ray, placed.world_from_object);
      if (searches_[i])
        searches_[i]->all(own, i, hits);
      else
        all_of_solid(own.object(), i, hits);
    }
  }

  std::vector<Bounds3> bounds() const {
    std::vector<Bounds3> boxes;
    for (const PlacedSurface& placed : scene_.placed())
      boxes.push_back(placed.surface->world_bounds(placed.world_from_object));
    return boxes;
  }

 private:
  Hit hit_of(std::uint32_t surface, const SurfaceHit& hit) const {
    return {surface, searches_[surface] ? hit.part : 0, hit.t, hit.u, hit.v};
  }

  /// One crossing after the other: those of a solid lie apart, or are one. No solid has more than the double cone's.
  void all_of_solid(Ray ray, std::uint32_t surface, std::vector<Hit>& hits) const {
    TraceCounters counters;
    for (int i = 0; i < 4; ++i) {
      const auto hit = scene_.placed()[surface].surface->intersect(ray, counters);
      if (!hit) return;
      hits.push_back(hit_of(surface, *hit));
      ray.t_min = std::nextafter(hit->t, Bounds3::kInfinity);
    }
  }

  /// Also fills `searches_`.
  SceneContents contents_of(std::span<const plumb_surface> surfaces) {
    SceneContents contents;
    std::map<MeshKey, std::size_t> known;
    std::vector<std::shared_ptr<MeshSearch>> search_of;
    MeshTable meshes;
    std::vector<std::string> warnings;
    SurfaceContext context{meshes, Accel::bvh8, warnings};
    for (const plumb_surface& from : surfaces) {
      const plumb_mesh& mesh = from.mesh;
      std::size_t index = contents.surfaces.size();
      bool is_new = true;
      if (from.kind == PLUMB_MESH)
        std::tie(index, is_new) =
            known_index(known, {mesh.positions, mesh.triangles, mesh.vertex_count, mesh.triangle_count}, index);
      if (is_new) {
        const std::string name = std::to_string(index);
        std::shared_ptr<MeshSearch> search;
        if (from.kind == PLUMB_MESH) {
          meshes[name] = std::make_shared<const TriangleMesh>(mesh_of(mesh));
          search = std::make_shared<MeshSearch>(meshes[name]);
        }
        contents.surfaces.push_back(element_of(from, name).make(context));
        search_of.push_back(std::move(search));
      }
      contents.placed.push_back({contents.surfaces[index].get(), transform_of(from), nullptr});
      searches_.push_back(search_of[index]);
    }
    return contents;
  }

  static std::pair<std::size_t, bool> known_index(std::map<MeshKey, std::size_t>& known, const MeshKey& key,
                                                  std::size_t next) {
    const auto [entry, is_new] = known.try_emplace(key, next);
    return {entry->second, is_new};
  }

  /// One a surface; null for solids. Before `scene_`, whose making fills it.
  std::vector<std::shared_ptr<MeshSearch>> searches_;
  Scene scene_;
};

constexpr plumb_contract kContract{.precision = PLUMB_DOUBLE,
                                   .t_precision = PLUMB_DOUBLE,
                                   .culling = PLUMB_CULL_NONE,
                                   .edge_rule = PLUMB_EDGE_WATERTIGHT,
                                   .range = PLUMB_RANGE_CLOSED,
                                   .inside = PLUMB_INSIDE_HITS_EXIT,
                                   .shapes = PLUMB_MESHES | PLUMB_SPHERES | PLUMB_BOXES | PLUMB_CYLINDERS | PLUMB_CONES,
                                   .capabilities = PLUMB_TRANSFORMS | PLUMB_THREAD_SAFE,
                                   .largest = 0};

}  // namespace
}  // namespace plumb::kernels

PLUMB_KERNEL_EXPORT const plumb_kernel* plumb_kernel_v1() {
  using namespace plumb::kernels;
  static const plumb_kernel table =
      KernelTable<PlumbKernel>::make("plumb", "our own tracer: its surfaces in doubles, in its hierarchies", kContract);
  return &table;
}
