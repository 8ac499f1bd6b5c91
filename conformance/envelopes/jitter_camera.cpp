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
  CameraPlace place{{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, std::nullopt};  // where a scene has no camera
  if (const ObjectPointer camera = description.scene->object("camera")) {
    place = {camera->point("viewPoint"), camera->vector("viewDir"), camera->vector("viewUp"), std::nullopt};
    if (camera->has("projNormal")) place.proj_normal = camera->vector("projNormal");
  }
  Random random(seed, description.file.filename().string(), static_cast<std::uint64_t>(view));
  const Vec3 k = kHalfTangent * in_ball(random);
  const Vec3 to_target = median_distance(scene) * normalized(place.view_dir);
  place.view_point = place.view_point + (to_target - turned(to_target, k));
  place.view_dir = turned(place.view_dir, k);
  place.view_up = turned(place.view_up, k);
  if (place.proj_normal) place.proj_normal = turned(*place.proj_normal, k);
  return place;
}

}  // namespace plumb
