#include "conformance/envelopes/jitter_camera.h"

#include <algorithm>
#include <vector>

#include "conformance/families/random.h"
#include "renderer/integrator/trace_counters.h"

namespace plumb {
namespace {

/// tan(4 degrees / 2), rounded down.
constexpr double kHalfTangent = 0.0349;

/// The rotation with the vector k = axis tan(angle / 2): v + 2 (k x v + k x (k x v)) / (1 + k.k) [Cayley 1846].
Vec3 turned(const Vec3& v, const Vec3& k) {
  const Vec3 once = cross(k, v);
  return v + 2 / (1 + dot(k, k)) * (once + cross(k, once));
}

/// In the ball of radius 1, by rejection.
Vec3 in_ball(Random& random) {
  for (;;) {
    const double x = random.between(-1, 1), y = random.between(-1, 1), z = random.between(-1, 1);
    const Vec3 v{x, y, z};
    if (dot(v, v) <= 1) return v;
  }
}

double median_distance(const Scene& scene) {
  constexpr int kSide = 8;
  std::vector<double> distances;
  TraceCounters counters;
  for (int j = 0; j < kSide; ++j)
    for (int i = 0; i < kSide; ++i) {
      const Ray ray = scene.camera().ray((i + 0.5) / kSide, (j + 0.5) / kSide);
      if (const auto hit = scene.closest_hit(ray, counters)) distances.push_back(hit->hit.t * length(ray.direction));
    }
  if (distances.empty()) return 1;
  std::ranges::sort(distances);
  return distances[distances.size() / 2];
}

}  // namespace

CameraPlace jittered_camera(const SceneDescription& description, const Scene& scene, std::uint64_t seed, int view) {
  const ObjectDescription& camera = *description.scene->object("camera");
  Random random(seed, description.file.filename().string(), static_cast<std::uint64_t>(view));
  const Vec3 k = kHalfTangent * in_ball(random);
  const Point3 eye = camera.point("viewPoint");
  const Vec3 view_dir = camera.vector("viewDir");
  const Vec3 to_target = median_distance(scene) * normalized(view_dir);
  CameraPlace place{eye + (to_target - turned(to_target, k)), turned(view_dir, k), turned(camera.vector("viewUp"), k),
                    std::nullopt};
  if (camera.has("projNormal")) place.proj_normal = turned(camera.vector("projNormal"), k);
  return place;
}

}  // namespace plumb
