#include "renderer/accel/bvh8_walk.h"

#include <bit>
#include <cstdint>
#include <limits>
#include <optional>

#define HWY_DISABLED_TARGETS HWY_SSSE3  // SSE4 and the scalar baseline are enough below AVX2
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/accel/bvh8_walk.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "renderer/accel/bvh8_walk-inl.h"

HWY_BEFORE_NAMESPACE();
namespace plumb {
namespace HWY_NAMESPACE {

/// Offers each triangle that the filter does not reject to a ClosestTriangle, which is made when the first comes up.
template <bool kAny>
class FilteredLeaves {
 public:
  HWY_INLINE FilteredLeaves(const SearchedMesh& searched, const PlacedRay& ray, const FilterRay& filter)
      : searched_(searched), ray_(ray), filter_(filter) {}

  HWY_INLINE bool visit(const Bvh8Leaf& leaf, float& t_max) {
    std::uint32_t candidates = test(leaf, t_max);
    if (candidates == 0) return false;
    if (!closest_) closest_.emplace(ray_, searched_.mesh, searched_.largest_coordinate);
    do {
      const auto slot = static_cast<std::uint32_t>(std::countr_zero(candidates));
      candidates &= candidates - 1;
      const TriangleNumbers::Number triangle = searched_.tree.triangles[leaf.first + slot];
      const TriangleVertices corners = searched_.tree.exact_vertices ? corners_of(leaf, slot) : corners_of(triangle);
      if constexpr (kAny) {
        if (closest_->meets(corners)) return true;
      } else {
        closest_->offer(triangle, corners);
      }
    } while (candidates != 0);
    if constexpr (!kAny) t_max = filter_.frame_t_max(closest_->t_max());
    return false;
  }

  HWY_INLINE std::optional<SurfaceHit> result() const { return closest_ ? closest_->result() : std::nullopt; }

 private:
  /// Which triangles of the leaf the ray may hit: all but those with the line surely on different sides of two edges,
  /// or which it surely meets before t_min or beyond t_max.
  HWY_INLINE std::uint32_t test(const Bvh8Leaf& leaf, float t_max) const {
    const Float8 ax = load8(leaf.vertices[filter_.axis[0]].data()) - all8(filter_.origin[0]);
    const Float8 ay = load8(leaf.vertices[filter_.axis[1]].data()) - all8(filter_.origin[1]);
    const Float8 az = load8(leaf.vertices[filter_.axis[2]].data()) - all8(filter_.origin[2]);
    const Float8 x = less_product(ax, all8(filter_.shear_x), az);
    const Float8 y = less_product(ay, all8(filter_.shear_y), az);
    const Float8 size = size_of(x) + size_of(y);
    const Lanes8 a = lanes_from(leaf.corner[0].data()), b = lanes_from(leaf.corner[1].data()),
                 c = lanes_from(leaf.corner[2].data());
    const Float8 xa = taken(x, a), xb = taken(x, b), xc = taken(x, c);
    const Float8 ya = taken(y, a), yb = taken(y, b), yc = taken(y, c);
    const Float8 sizes = (taken(size, a) + taken(size, b)) + taken(size, c);
    const Float8 u = product_less(xc, yb, yc * xb), v = product_less(xa, yc, ya * xc),
                 w = product_less(xb, ya, yb * xa);
    const Float8 error = product_plus(sizes, all8(filter_.weight_error), all8(filter_.weight_error_constant));
    const Float8 lowest = low(low(u, v), w), highest = high(high(u, v), w);
    // Rejected: lowest < -error and highest > error.
    const std::uint32_t kept = at_most(negative(error), lowest) | at_most(highest, error);
    const std::uint32_t candidates = kept & leaf.present;
    if (candidates == 0 || (filter_.t_min < 0x1p-100F && t_max == std::numeric_limits<float>::infinity()))
      return candidates;

    // t is that of the first corner's plane and, over det, `rise`: how much that of the two others differs, by weight.
    // Signs are turned so that det > 0.
    const Float8 za = taken(az, a);
    const Float8 zb = taken(az, b) - za, zc = taken(az, c) - za;
    const Float8 det = (u + v) + w;
    const Float8 area = size_of(det);
    const Float8 t_a = za * all8(filter_.reciprocal_z);
    const Float8 rise = negated_like(product_plus(v, zb, w * zc) * all8(filter_.reciprocal_z), det);
    const Float8 area_error = product_plus(error, all8(kAreaError), area * all8(0x1p-21F));
    const Float8 rise_error = product_plus(error * (size_of(zb) + size_of(zc)), all8(filter_.reciprocal_size_z),
                                           product_plus(error, all8(kWeightsError), area) * all8(filter_.depth_error));
    const Float8 start = all8(filter_.t_min) - t_a, end = all8(t_max) - t_a;
    const std::uint32_t not_before = at_most(product_less(start, area, size_of(start) * area_error), rise + rise_error);
    const std::uint32_t not_beyond = at_most(rise - rise_error, product_plus(end, area, size_of(end) * area_error));
    const std::uint32_t is_flat = at_most(area, area_error);
    return candidates & ((not_before & not_beyond) | is_flat);
  }

  /// How far det may be off, in errors of a weight; and how much larger than det the sum of the weights' sizes may be.
  static constexpr float kAreaError = 3.2F, kWeightsError = 4.1F;

  /// The mesh's own, where the leaf has them to the bit.
  HWY_INLINE TriangleVertices corners_of(const Bvh8Leaf& leaf, std::uint32_t slot) const {
    const auto corner = [&](std::size_t k) {
      const std::uint8_t i = leaf.corner[k][slot];
      return Point3{leaf.vertices[0][i], leaf.vertices[1][i], leaf.vertices[2][i]};
    };
    return {corner(0), corner(1), corner(2)};
  }
  HWY_INLINE TriangleVertices corners_of(std::uint32_t triangle) const {
    const auto& [a, b, c] = searched_.mesh.triangles[triangle];
    return {searched_.mesh.positions[a], searched_.mesh.positions[b], searched_.mesh.positions[c]};
  }

  const SearchedMesh& searched_;
  const PlacedRay& ray_;
  const FilterRay& filter_;
  std::optional<ClosestTriangle> closest_;
};

std::optional<SurfaceHit> closest(const SearchedMesh& searched, const PlacedRay& ray, const FilterRay& filter,
                                  TraceCounters& counters) {
  FilteredLeaves<false> leaves(searched, ray, filter);
  Walk(searched.tree, filter).to_nearest(leaves, counters);
  return leaves.result();
}

bool any(const SearchedMesh& searched, const PlacedRay& ray, const FilterRay& filter, TraceCounters& counters) {
  FilteredLeaves<true> leaves(searched, ray, filter);
  return Walk(searched.tree, filter).to_any(leaves, counters);
}

}  // namespace HWY_NAMESPACE
}  // namespace plumb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace plumb {

HWY_EXPORT(closest);
HWY_EXPORT(any);

namespace {

[[gnu::always_inline]] inline FilterRay::Fate prepare(const SearchedMesh& searched, const PlacedRay& ray,
                                                      FilterRay& filter) {
  const FilterRay::Fate fate =
      make_filter_ray(ray.object(), {ray.origin_error, ray.direction_error}, searched.tree.frame, filter);
  if (fate != FilterRay::Fate::walk) return fate;
  if (searched.tree.lines.size() == 0) return FilterRay::Fate::misses;
  if (ray.nearest < ray.object().t_max) filter.t_max = std::min(filter.t_max, filter.frame_t_max(ray.nearest));
  return fate;
}

ClosestTriangle search(const SearchedMesh& searched, const PlacedRay& ray) {
  return {ray, searched.mesh, searched.largest_coordinate};
}

// Not part of their callers, which every ray goes through: they would take more registers.
[[gnu::noinline]] std::optional<SurfaceHit> closest_of_all(const SearchedMesh& searched, const PlacedRay& ray,
                                                           TraceCounters& counters) {
  ClosestTriangle closest = search(searched, ray);
  const auto count = static_cast<std::uint32_t>(searched.mesh.triangles.size());
  for (std::uint32_t triangle = 0; triangle < count; ++triangle) closest.offer(triangle);
  counters.primitive_tests += count;
  return closest.result();
}

[[gnu::noinline]] bool any_of_all(const SearchedMesh& searched, const PlacedRay& ray, TraceCounters& counters) {
  const ClosestTriangle triangles = search(searched, ray);
  const auto count = static_cast<std::uint32_t>(searched.mesh.triangles.size());
  for (std::uint32_t triangle = 0; triangle < count; ++triangle) {
    ++counters.primitive_tests;
    if (triangles.meets(triangle)) return true;
  }
  return false;
}

}  // namespace

std::optional<SurfaceHit> closest_in_bvh8(const SearchedMesh& searched, const PlacedRay& ray, TraceCounters& counters) {
  FilterRay filter;
  switch (prepare(searched, ray, filter)) {
    case FilterRay::Fate::walk:
      return HWY_DYNAMIC_DISPATCH(closest)(searched, ray, filter, counters);
    case FilterRay::Fate::misses:
      return std::nullopt;
    case FilterRay::Fate::unfiltered:
      break;
  }
  return closest_of_all(searched, ray, counters);
}

bool any_in_bvh8(const SearchedMesh& searched, const PlacedRay& ray, TraceCounters& counters) {
  FilterRay filter;
  switch (prepare(searched, ray, filter)) {
    case FilterRay::Fate::walk:
      return HWY_DYNAMIC_DISPATCH(any)(searched, ray, filter, counters);
    case FilterRay::Fate::misses:
      return false;
    case FilterRay::Fate::unfiltered:
      break;
  }
  return any_of_all(searched, ray, counters);
}

}  // namespace plumb
#endif
