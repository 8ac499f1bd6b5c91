#include "renderer/accel/bvh8_walk.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>

#define HWY_DISABLED_TARGETS HWY_SSSE3  // SSE4 and the scalar baseline are enough below AVX2
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/accel/bvh8_walk.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "renderer/accel/bvh8_walk-inl.h"
#include "renderer/accel/filtered_leaves-inl.h"

namespace plumb {

// By every triangle, where floats cannot tell. Not part of the walks, which would take more registers.
std::optional<SurfaceHit> closest_of_all(const SearchedMesh& searched, const PlacedRay& ray, TraceCounters& counters);
bool any_of_all(const SearchedMesh& searched, const PlacedRay& ray, TraceCounters& counters);

}  // namespace plumb

HWY_BEFORE_NAMESPACE();
namespace plumb {
namespace HWY_NAMESPACE {

HWY_INLINE FilterRay::Fate prepare(const SearchedMesh& searched, const PlacedRay& ray, FilterRay& filter,
                                   BoxRay& boxes) {
  const FilterRay::Fate fate = make_filter_ray(ray, searched.tree.frame, filter, boxes);
  if (fate != FilterRay::Fate::walk) return fate;
  if (searched.tree.lines.size() == 0) return FilterRay::Fate::misses;
  if (ray.nearest < std::numeric_limits<double>::infinity())
    filter.range.t_max = std::min(filter.range.t_max, filter.frame_t_max(ray.nearest));
  return fate;
}

std::optional<SurfaceHit> closest(const SearchedMesh& searched, const PlacedRay& ray, TraceCounters& counters) {
  FilterRay filter;
  BoxRay boxes;
  const FilterRay::Fate fate = prepare(searched, ray, filter, boxes);
  if (fate == FilterRay::Fate::walk) {
    FilteredLeaves<false> leaves(searched, ray, filter);
    Walk(searched.tree, filter, boxes).to_nearest(leaves, counters);
    return leaves.result();
  }
  return fate == FilterRay::Fate::misses ? std::nullopt : closest_of_all(searched, ray, counters);
}

bool any(const SearchedMesh& searched, const PlacedRay& ray, TraceCounters& counters) {
  FilterRay filter;
  BoxRay boxes;
  const FilterRay::Fate fate = prepare(searched, ray, filter, boxes);
  if (fate == FilterRay::Fate::walk) {
    FilteredLeaves<true> leaves(searched, ray, filter);
    return Walk(searched.tree, filter, boxes).to_any(leaves, counters);
  }
  return fate == FilterRay::Fate::unfiltered && any_of_all(searched, ray, counters);
}

}  // namespace HWY_NAMESPACE
}  // namespace plumb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace plumb {

HWY_EXPORT(closest);
HWY_EXPORT(any);

std::optional<SurfaceHit> closest_of_all(const SearchedMesh& searched, const PlacedRay& ray, TraceCounters& counters) {
  ClosestTriangle closest(ray, *searched.mesh, searched.largest_coordinate);
  const auto count = static_cast<std::uint32_t>(searched.mesh->triangles.size());
  for (std::uint32_t triangle = 0; triangle < count; ++triangle) closest.offer(triangle);
  counters.primitive_tests += count;
  return closest.result();
}

bool any_of_all(const SearchedMesh& searched, const PlacedRay& ray, TraceCounters& counters) {
  const ClosestTriangle triangles(ray, *searched.mesh, searched.largest_coordinate);
  const auto count = static_cast<std::uint32_t>(searched.mesh->triangles.size());
  for (std::uint32_t triangle = 0; triangle < count; ++triangle) {
    ++counters.primitive_tests;
    if (triangles.meets(triangle)) return true;
  }
  return false;
}

Bvh8Walks bvh8_walks() {
#ifndef HWY_COMPILE_ONLY_STATIC
  hwy::ChosenTarget& target = hwy::GetChosenTarget();
  if (!target.IsInitialized()) target.Update(hwy::SupportedTargets());
#endif
  return {&HWY_DYNAMIC_DISPATCH(closest), &HWY_DYNAMIC_DISPATCH(any)};
}

}  // namespace plumb
#endif
