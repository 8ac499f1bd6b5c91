#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "renderer/accel/accelerator.h"
#include "renderer/integrator/trace_counters.h"
#include "renderer/math/bounds3.h"
#include "renderer/math/placed_ray.h"
#include "renderer/math/ray.h"
#include "renderer/surfaces/exact_triangle.h"
#include "scenes/load_meshes.h"
#include "scenes/object_description.h"

namespace plumb {

class TriangleSearch;

/// Where a ray meets a surface: enough to find the normal later, so that only the closest hit pays for it.
struct SurfaceHit {
  double t = 0;
  /// Barycentric weights of the second and third vertex; 0 for other surfaces.
  double u = 0, v = 0;
  /// The triangle of a mesh, the face or side of a solid.
  std::uint32_t part = 0;
  /// Of a triangle: how far the exact t, which decides what is closest, may be from t. Other surfaces have no other t
  /// than that one.
  double t_error = 0;
};

/// A shape in its own frame (object space). Const and safe to use from any number of threads.
class Surface {
 public:
  virtual ~Surface() = default;

  /// The smallest hit with t in the ray's closed range; of equal ones that of the lowest part. The ray's
  /// direction has any length but zero. A ray with NaN hits nothing.
  virtual std::optional<SurfaceHit> intersect(const Ray& ray, TraceCounters& counters) const = 0;

  /// Whether anything of the surface lies in the ray's range.
  virtual bool blocks(const Ray& ray, TraceCounters& counters) const { return intersect(ray, counters).has_value(); }

  /// The same for a surface that has been placed, by a ray of the world. Solids take the rounded ray as it is, and what
  /// lies beyond `nearest` as out of range. Meshes decide for the world's ray.
  virtual std::optional<SurfaceHit> intersect_placed(const PlacedRay& ray, TraceCounters& counters) const;
  virtual bool blocks_placed(const PlacedRay& ray, TraceCounters& counters) const {
    return blocks(ray.object(), counters);
  }

  /// The corners of a part that is a flat triangle, which is hit as an exact one; nothing of other surfaces.
  virtual std::optional<TriangleVertices> triangle(std::uint32_t) const { return std::nullopt; }

  /// The outward normal at a hit of this ray on this surface; of any length.
  virtual Normal3 normal(const Ray& ray, const SurfaceHit& hit) const = 0;

  /// The smallest box, in doubles, that holds the surface as its numbers define it, in object space.
  Bounds3 bounds() const { return world_bounds(Transform()); }

  /// The same in world space, of the surface mapped by the transform's matrix without rounding.
  virtual Bounds3 world_bounds(const Transform& world_from_object) const = 0;
};

inline std::optional<SurfaceHit> Surface::intersect_placed(const PlacedRay& ray, TraceCounters& counters) const {
  Ray rest = ray.object();
  if (ray.nearest < rest.t_max) rest.t_max = ray.nearest;
  return intersect(rest, counters);
}

/// What the making of a surface needs beside its own description.
struct SurfaceContext {
  const MeshTable& meshes;
  Accel accel;
  std::vector<std::string>& warnings;
  /// How many may build, at least 1.
  int threads = 1;
  /// Those made so far: several elements with the same mesh share one.
  std::map<const TriangleMesh*, std::shared_ptr<const TriangleSearch>> searches{};
};

/// A kind of surface: its parameter table and how one is made. Making throws InputError at the parameter at fault.
struct SurfaceKind {
  Kind kind;
  std::unique_ptr<Surface> (*make)(const ObjectDescription&, SurfaceContext&);
};

/// Every kind, sorted by file name.
std::span<const SurfaceKind* const> surface_kinds();

/// The row of the parameter tables that every surface has.
inline constexpr Parameter surface_shader_parameter{
    .name = "shader",
    .type = ValueType::object,
    .meaning = "how it is shaded; without one that of the group around it, else white Lambertian",
    .presence = Presence::optional,
    .role = Role::shader};

}  // namespace plumb
