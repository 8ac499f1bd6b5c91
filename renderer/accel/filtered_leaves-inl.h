// The triangles of the leaves that a walk visits; included once a target.
#if defined(PLUMB_RENDERER_ACCEL_FILTERED_LEAVES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_RENDERER_ACCEL_FILTERED_LEAVES_INL_H
#undef PLUMB_RENDERER_ACCEL_FILTERED_LEAVES_INL_H
#else
#define PLUMB_RENDERER_ACCEL_FILTERED_LEAVES_INL_H
#endif

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "renderer/accel/bvh8_layout.h"
#include "renderer/accel/bvh8_walk-inl.h"
#include "renderer/accel/bvh8_walk.h"
#include "renderer/accel/filter_ray.h"
#include "renderer/accel/lanes8-inl.h"
#include "renderer/accel/met_triangle-inl.h"

HWY_BEFORE_NAMESPACE();
namespace plumb {
namespace HWY_NAMESPACE {

/// Looks at the triangles of leaves. What floats leave open goes to a ClosestTriangle, which is made when it is needed;
/// of those that they know to be met the nearest waits until the end.
template <bool kAny>
class FilteredLeaves {
 public:
  HWY_INLINE FilteredLeaves(const SearchedMesh& searched, const PlacedRay& ray, const FilterRay& filter)
      : searched_(searched), ray_(ray), filter_(filter) {}

  HWY_INLINE bool visit(const Bvh8Leaf& leaf, float& t_max) {
    std::uint32_t kept = test(leaf, t_max);
    if constexpr (kAny) {
      if (met_.surely != 0) return true;
      return met_.maybe != 0 && is_any_met(leaf);
    } else {
      if ((met_.maybe & ~met_.surely) != 0) {
        t_max = settle(leaf, t_max);
        return false;
      }
      // A slot comes from `kept`, which is known long before `met_`: all that follows waits for it. Whether that
      // triangle may be met is a branch, which the processor guesses.
      while (kept != 0) {
        const std::uint32_t slot = taken_slot(kept);
        if ((met_.maybe >> slot & 1) == 0) continue;
        const float near = met_.near[slot], far = met_.far[slot];
        if (near > t_max) continue;
        if (waiting_.leaf != nullptr && !(far < waiting_.near)) {
          met_.maybe &= kept | 1U << slot;
          t_max = settle(leaf, t_max);
          return false;
        }
        waiting_ = {&leaf, slot, near};
        t_max = std::min(t_max, far);
      }
      return false;
    }
  }

  HWY_INLINE std::optional<SurfaceHit> result() {
    if (waiting_.leaf != nullptr && !closest_) {
      SurfaceHit hit;
      if (is_plain(*waiting_.leaf, waiting_.slot, hit)) {
        hit.part = searched_.tree.triangles[waiting_.leaf->first + waiting_.slot];
        return hit;
      }
    }
    return waiting_.leaf != nullptr || closest_ ? settled() : std::nullopt;
  }

 private:
  /// Triangles that the ray is known to meet within its range, a bit for each; and for all where it meets their planes,
  /// between which t of the frame.
  struct Met {
    std::uint32_t surely = 0;
    /// And those that it may meet, within its range or at no known t.
    std::uint32_t maybe = 0;
    alignas(32) std::array<float, 8> near, far;
  };

  /// Looks at the triangles of the leaf and fills in `met_`, `near` and `far` only where any is returned: all but those
  /// that the line passes by, surely on different sides of two edges, whatever the range.
  HWY_INLINE std::uint32_t test(const Bvh8Leaf& leaf, float t_max) {
    const auto from_origin = [&](int k) {
      const auto* const row = reinterpret_cast<const std::byte*>(&leaf) + static_cast<std::uint32_t>(filter_.row[k]);
      return load8(reinterpret_cast<const float*>(row)) - all8(filter_.origin[k]);
    };
    const Float8 az = from_origin(2);
    const Float8 x = less_product(from_origin(0), all8(filter_.shear[0]), az);
    const Float8 y = less_product(from_origin(1), all8(filter_.shear[1]), az);
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
    const std::uint32_t kept = (at_most(negative(error), lowest) | at_most(highest, error)) & leaf.present;
    if (kept == 0) {
      met_.surely = met_.maybe = 0;
      return 0;
    }

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
    const Float8 reciprocal = quotient(all8(1), area);
    const Float8 beyond_a = rise * reciprocal;
    const Float8 t = t_a + beyond_a;
    const Float8 t_error =
        product_plus(size_of(beyond_a), area_error, rise_error) * (reciprocal * all8(kQuotientError));
    const Float8 near = t - t_error, far = t + t_error;
    store8(near, met_.near.data());
    store8(far, met_.far.data());
    const std::uint32_t has_t = at_most(area_error * all8(2), area);
    const std::uint32_t is_inside = at_most(error, lowest) | at_most(highest, negative(error));
    const std::uint32_t is_in_range =
        at_most(all8(filter_.range.surely_from), near) & at_most(far, all8(filter_.range.surely_to));
    const std::uint32_t may_be_in_range = at_most(all8(filter_.range.t_min), far) & at_most(near, all8(t_max));
    met_.maybe = kept & (may_be_in_range | ~has_t);
    met_.surely = kept & has_t & is_inside & is_in_range;
    return kept;
  }

  /// How far det may be off, in errors of a weight; how much larger than det the sum of the weights' sizes may be; and
  /// how far a quotient of which the lower part is off by half.
  static constexpr float kAreaError = 3.2F, kWeightsError = 4.1F, kQuotientError = 2.001F;

  HWY_INLINE ClosestTriangle& exact() {
    if (!closest_) closest_.emplace(ray_, *searched_.mesh, searched_.largest_coordinate);
    return *closest_;
  }
  HWY_INLINE void offer(const Bvh8Leaf& leaf, std::uint32_t slot) {
    exact().offer(searched_.tree.triangles[leaf.first + slot], corners_of(leaf, slot));
  }

  // What is needed rarely is not part of the walk, which would keep less in registers.

  HWY_NOINLINE bool is_any_met(const Bvh8Leaf& leaf) {
    for (std::uint32_t rest = met_.maybe; rest != 0;)
      if (exact().meets(corners_of(leaf, taken_slot(rest)))) return true;
    return false;
  }

  /// Takes the triangles that may be met into account, exactly where it must; returns the new t_max.
  HWY_NOINLINE float settle(const Bvh8Leaf& leaf, float t_max) {
    for (std::uint32_t rest = met_.maybe; rest != 0;) {
      const std::uint32_t slot = taken_slot(rest);
      if ((met_.surely >> slot & 1) == 0) {
        offer(leaf, slot);
        t_max = std::min(t_max, filter_.frame_t_max(closest_->t_max()));
        continue;
      }
      if (met_.near[slot] > t_max) continue;
      if (waiting_.leaf != nullptr && !(met_.far[slot] < waiting_.near)) offer(*waiting_.leaf, waiting_.slot);
      waiting_ = {&leaf, slot, met_.near[slot]};
      t_max = std::min(t_max, met_.far[slot]);
    }
    return t_max;
  }

  HWY_NOINLINE std::optional<SurfaceHit> settled() {
    if (waiting_.leaf != nullptr) offer(*waiting_.leaf, waiting_.slot);
    return closest_->result();
  }

  /// Whether the hit of a triangle that is met is found without a ClosestTriangle.
  HWY_INLINE bool is_plain(const Bvh8Leaf& leaf, std::uint32_t slot, SurfaceHit& hit) const {
    // Floats know hits only of rays that are near.
    const double error = ray_.is_exact() ? searched_.near_weight_error : placed_weight_error();
    if (!searched_.tree.exact_vertices) return met_plainly(ray_, filter_.axis, error, mesh_corners_of(leaf, slot), hit);
    const auto corner = [&](std::size_t k) {
      const std::uint8_t i = leaf.corner[k][slot];
      return BoxSide{leaf.vertices[0][i], leaf.vertices[1][i], leaf.vertices[2][i], 0};
    };
    return met_plainly(ray_, filter_.axis, error, std::array{corner(0), corner(1), corner(2)}, hit);
  }
  HWY_NOINLINE double placed_weight_error() const {
    const double m = 1.001 * (searched_.largest_coordinate + largest_coordinate(ray_.object().origin));
    const ShearedRay sheared(ray_);
    return any_weight_error(m, sheared.drift, sheared.drift_growth);
  }

  /// The mesh's own; from the leaf, where that has them to the bit.
  HWY_INLINE TriangleVertices corners_of(const Bvh8Leaf& leaf, std::uint32_t slot) const {
    if (!searched_.tree.exact_vertices) return mesh_corners_of(leaf, slot);
    const auto corner = [&](std::size_t k) {
      const std::uint8_t i = leaf.corner[k][slot];
      return Point3{leaf.vertices[0][i], leaf.vertices[1][i], leaf.vertices[2][i]};
    };
    return {corner(0), corner(1), corner(2)};
  }
  HWY_INLINE TriangleVertices mesh_corners_of(const Bvh8Leaf& leaf, std::uint32_t slot) const {
    const auto& [a, b, c] = searched_.mesh->triangles[searched_.tree.triangles[leaf.first + slot]];
    return {searched_.mesh->positions[a], searched_.mesh->positions[b], searched_.mesh->positions[c]};
  }

  const SearchedMesh& searched_;
  const PlacedRay& ray_;
  const FilterRay& filter_;
  std::optional<ClosestTriangle> closest_;
  Met met_;
  /// A triangle that is met, and not before `near`; what is met before it, if anything, was offered.
  struct {
    const Bvh8Leaf* leaf = nullptr;
    std::uint32_t slot = 0;
    float near = 0;
  } waiting_;
};

}  // namespace HWY_NAMESPACE
}  // namespace plumb
HWY_AFTER_NAMESPACE();

#endif
