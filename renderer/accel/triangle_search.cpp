#include "renderer/accel/triangle_search.h"

#include <algorithm>
#include <vector>

namespace plumb {

TriangleSearch::TriangleSearch(std::shared_ptr<const TriangleMesh> mesh, Accel accel, int threads)
    : mesh_(std::move(mesh)), search_(make(mesh_, accel, threads)) {}

TriangleSearch::Search TriangleSearch::make(const std::shared_ptr<const TriangleMesh>& mesh, Accel accel, int threads) {
  if (accel == Accel::bvh8) return Bvh8(mesh, {.threads = threads});
  const std::vector<Bounds3> bounds = triangle_bounds(*mesh);
  double largest = 0;
  for (const Bounds3& box : bounds) largest = std::max(largest, largest_coordinate(box));
  return Boxes{Accelerator(accel, bounds), largest};
}

std::optional<SurfaceHit> TriangleSearch::closest(const PlacedRay& ray, TraceCounters& counters) const {
  if (const Bvh8* const wide = std::get_if<Bvh8>(&search_)) return wide->closest(ray, counters);
  const auto& [accelerator, largest] = std::get<Boxes>(search_);
  ClosestTriangle closest(ray, *mesh_, largest);
  Ray rest = ray.object();
  rest.t_max = closest.t_max();
  const auto offer = [&](std::uint32_t triangle) {
    ++counters.primitive_tests;
    closest.offer(triangle);
    rest.t_max = closest.t_max();
    return false;
  };
  accelerator.walk(rest, counters, offer, ray.drift(largest));
  return closest.result();
}

bool TriangleSearch::any(const PlacedRay& ray, TraceCounters& counters) const {
  if (const Bvh8* const wide = std::get_if<Bvh8>(&search_)) return wide->any(ray, counters);
  const auto& [accelerator, largest] = std::get<Boxes>(search_);
  const ClosestTriangle triangles(ray, *mesh_, largest);
  const auto meets = [&](std::uint32_t triangle) {
    ++counters.primitive_tests;
    return triangles.meets(triangle);
  };
  return accelerator.walk(ray.object(), counters, meets, ray.drift(largest));
}

}  // namespace plumb
