#pragma once

#include "renderer/integrator/trace_counters.h"
#include "renderer/scene.h"

namespace plumb {

/// Follows rays through a scene, recursively [Whitted 1980]. One a thread; it counts what it does. (Aligned, so that
/// the counters of two threads do not share a cache line.)
class alignas(64) Tracer {
 public:
  explicit Tracer(const Scene& scene) : scene_(scene) {}

  /// The light that comes back along the ray; black where it meets nothing.
  Color trace(const Ray& ray, RayKind kind, const Path& path);

  /// A ray that a shader sends on, its origin on the surface and its direction of unit length, weighted by `weight`:
  /// black where it would be deeper than the scene's maximum depth, or would count for less than its minimum
  /// contribution. The weight is not applied to the result.
  Color follow(const Ray& ray, RayKind kind, const Path& path, double weight);

  /// Whether nothing stands between the point and the light. Every surface blocks, glass too.
  bool sees(const Point3& point, const LightSample& light);

  const Scene& scene() const { return scene_; }
  const TraceCounters& counters() const { return counters_; }

 private:
  const Scene& scene_;
  TraceCounters counters_;
};

/// Where a ray from a surface begins to count, so that it does not meet the surface it leaves. The course's value;
/// 1e-10 changes its pictures.
constexpr double kRayOffset = 1e-6;

}  // namespace plumb
