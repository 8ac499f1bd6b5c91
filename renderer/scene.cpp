#include "renderer/scene.h"

#include <utility>

namespace plumb {
namespace {

std::vector<Bounds3> world_bounds(const std::vector<PlacedSurface>& placed) {
  std::vector<Bounds3> bounds;
  bounds.reserve(placed.size());
  for (const PlacedSurface& p : placed) bounds.push_back(p.surface->world_bounds(p.world_from_object));
  return bounds;
}

/// The ray in the surface's own frame; a surface outside of any group pays nothing for groups.
Ray object_ray(const PlacedSurface& placed, const Ray& world) {
  return placed.world_from_object.is_identity() ? world : placed.world_from_object.inverse_of(world);
}

}  // namespace

Scene::Scene(SceneContents contents, Accel accel)
    : contents_(std::move(contents)), accelerator_(accel, world_bounds(contents_.placed)) {}

std::optional<Scene::Hit> Scene::closest_hit(const Ray& ray, TraceCounters& counters) const {
  std::optional<Hit> closest;
  Ray rest = ray;
  accelerator_.walk(rest, counters, [&](std::uint32_t index) {
    ++counters.primitive_tests;
    const PlacedSurface& placed = contents_.placed[index];
    const std::optional<SurfaceHit> hit = placed.surface->intersect(object_ray(placed, rest), counters);
    if (hit && (!closest || hit->t < closest->hit.t || index < closest->placed)) {
      closest = Hit{*hit, index};
      rest.t_max = hit->t;
    }
    return false;
  });
  return closest;
}

bool Scene::blocks(const Ray& ray, TraceCounters& counters) const {
  return accelerator_.walk(ray, counters, [&](std::uint32_t index) {
    ++counters.primitive_tests;
    const PlacedSurface& placed = contents_.placed[index];
    return placed.surface->blocks(object_ray(placed, ray), counters);
  });
}

ShadingPoint Scene::shading_point(const Ray& ray, const Hit& hit) const {
  const PlacedSurface& placed = contents_.placed[hit.placed];
  const Normal3 normal = placed.surface->normal(object_ray(placed, ray), hit.hit);
  return {ray.at(hit.hit.t),
          normalized(placed.world_from_object.is_identity() ? normal : placed.world_from_object(normal)),
          normalized(-ray.direction)};
}

}  // namespace plumb
