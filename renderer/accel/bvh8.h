#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "meshes/triangle_mesh.h"
#include "renderer/accel/bvh8_builder.h"
#include "renderer/accel/bvh8_walk.h"
#include "renderer/integrator/trace_counters.h"
#include "renderer/math/placed_ray.h"
#include "renderer/surfaces/closest_triangle.h"

namespace plumb {

/// The triangles of a mesh in an 8-wide hierarchy that is walked by SIMD, in floats: a box or triangle is passed by
/// only where a proven bound of every rounding says that the ray misses it (docs/certified-kernel.md); the rest is
/// decided by ClosestTriangle. So the hits are those of a search through all triangles, to the bit, on every
/// instruction set. Const and safe to use from any number of threads.
class Bvh8 {
 public:
  /// For the best instruction set that Highway's chosen target allows now.
  explicit Bvh8(std::shared_ptr<const TriangleMesh> mesh, const Bvh8Options& options = {});

  /// The hit with the smallest exact t in the ray's closed range, of equal ones that of the lowest triangle. A ray with
  /// NaN, an infinite coordinate or no direction hits nothing.
  std::optional<SurfaceHit> closest(const PlacedRay& ray, TraceCounters& counters) const {
    return walks_.closest(searched_, ray, counters);
  }
  /// Whether there is one.
  bool any(const PlacedRay& ray, TraceCounters& counters) const { return walks_.any(searched_, ray, counters); }

  /// What the hierarchy takes beside the mesh.
  std::size_t bytes() const;
  const Bvh8Tree& tree() const { return searched_.tree; }

 private:
  SearchedMesh searched_;
  Bvh8Walks walks_;
};

}  // namespace plumb
