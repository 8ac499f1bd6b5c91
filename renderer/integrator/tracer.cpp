#include "renderer/integrator/tracer.h"

namespace plumb {

Color Tracer::trace(const Ray& ray, RayKind kind, const Path& path) {
  ++counters_.rays[static_cast<std::size_t>(kind)];
  const std::optional<Scene::Hit> hit = scene_.closest_hit(ray, counters_);
  if (!hit) return {};
  return scene_.shader(*hit).shade(scene_.shading_point(ray, *hit), path, *this);
}

Color Tracer::follow(const Ray& ray, RayKind kind, const Path& path, double weight) {
  const Path next{path.depth + 1, path.contribution * weight};
  if (next.depth > scene_.max_depth() || next.contribution < scene_.min_contribution()) return {};
  Ray offset = ray;
  offset.t_min = kRayOffset;
  return trace(offset, kind, next);
}

bool Tracer::sees(const Point3& point, const LightSample& light) {
  ++counters_.rays[static_cast<std::size_t>(RayKind::shadow)];
  return !scene_.blocks({point, light.to_light, kRayOffset, 1}, counters_);
}

}  // namespace plumb
