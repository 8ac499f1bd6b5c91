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
    Met met;
    std::uint32_t candidates = test(leaf, t_max, met);
    if constexpr (kAny) {
      if (met.surely != 0) return true;
      while (candidates != 0)
        if (exact().meets(corners_of(leaf, taken_slot(candidates)))) return true;
    } else {
      while (candidates != 0) {
        const std::uint32_t slot = taken_slot(candidates);
        if ((met.surely >> slot & 1) != 0) {
          const float near = met.near[slot], far = met.far[slot];
          if (near > t_max) continue;
          if (waiting_.leaf != nullptr && !(far < waiting_.near)) offer(*waiting_.leaf, waiting_.slot);
          waiting_ = {&leaf, slot, near};
          t_max = std::min(t_max, far);
        } else {
          offer(leaf, slot);
          t_max = std::min(t_max, filter_.frame_t_max(closest_->t_max()));
        }
      }
    }
    return false;
  }

  HWY_INLINE std::optional<SurfaceHit> result() {
    if (waiting_.leaf != nullptr) {
      SurfaceHit hit;
      if (!closest_ && is_plain(*waiting_.leaf, waiting_.slot, hit)) {
        hit.part = searched_.tree.triangles[waiting_.leaf->first + waiting_.slot];
        return hit;
      }
      offer(*waiting_.leaf, waiting_.slot);
    }
    return closest_ ? closest_->result() : std::nullopt;
  }

 private:
  /// Triangles that the ray is known to meet within its range, a bit for each; and for all where it meets their planes,
  /// between which t of the frame.
  struct Met {
    std::uint32_t surely = 0;
    alignas(32) std::array<float, 8> near, far;
  };

  /// Which triangles of the leaf the ray may hit: all but those with the line surely on different sides of two edges,
  /// or which it surely meets before t_min or beyond t_max. `met` is filled in where there are any.
  HWY_INLINE std::uint32_t test(const Bvh8Leaf& leaf, float t_max, Met& met) const {
    const auto [kx, ky, kz, unused] = filter_.axis;
    const auto from_origin = [&](std::uint8_t axis) {
      return load8(leaf.vertices[axis].data()) - all8(filter_.origin[axis]);
    };
    const Float8 az = from_origin(kz);
    const Float8 x = less_product(from_origin(kx), all8(filter_.shear[kx]), az);
    const Float8 y = less_product(from_origin(ky), all8(filter_.shear[ky]), az);
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
    if (candidates == 0) return 0;

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
    store8(near, met.near.data());
    store8(far, met.far.data());
    const std::uint32_t has_t = at_most(area_error * all8(2), area);
    const std::uint32_t is_inside = at_most(error, lowest) | at_most(highest, negative(error));
    const std::uint32_t is_in_range = at_most(all8(filter_.surely_from), near) & at_most(far, all8(filter_.surely_to));
    const std::uint32_t may_be_in_range = at_most(all8(filter_.t_min), far) & at_most(near, all8(t_max));
    met.surely = candidates & has_t & is_inside & is_in_range;
    return candidates & (may_be_in_range | ~has_t);
  }

  /// How far det may be off, in errors of a weight; how much larger than det the sum of the weights' sizes may be; and
  /// how far a quotient of which the lower part is off by half.
  static constexpr float kAreaError = 3.2F, kWeightsError = 4.1F, kQuotientError = 2.001F;

  HWY_INLINE ClosestTriangle& exact() {
    if (!closest_) closest_.emplace(ray_, searched_.mesh, searched_.largest_coordinate);
    return *closest_;
  }
  HWY_INLINE void offer(const Bvh8Leaf& leaf, std::uint32_t slot) {
    exact().offer(searched_.tree.triangles[leaf.first + slot], corners_of(leaf, slot));
  }
  /// Whether the hit of a triangle that is met is found without a ClosestTriangle.
  HWY_INLINE bool is_plain(const Bvh8Leaf& leaf, std::uint32_t slot, SurfaceHit& hit) const {
    const double largest = searched_.largest_coordinate;
    return searched_.tree.exact_vertices ? met_plainly(ray_, largest, float_corners_of(leaf, slot), hit)
                                         : met_plainly(ray_, largest, mesh_corners_of(leaf, slot), hit);
  }

  /// The mesh's own; from the leaf, where that has them to the bit.
  HWY_INLINE TriangleVertices corners_of(const Bvh8Leaf& leaf, std::uint32_t slot) const {
    if (!searched_.tree.exact_vertices) return mesh_corners_of(leaf, slot);
    const auto [a, b, c] = float_corners_of(leaf, slot);
    return {Point3{a.x, a.y, a.z}, {b.x, b.y, b.z}, {c.x, c.y, c.z}};
  }
  HWY_INLINE TriangleVertices mesh_corners_of(const Bvh8Leaf& leaf, std::uint32_t slot) const {
    const auto& [a, b, c] = searched_.mesh.triangles[searched_.tree.triangles[leaf.first + slot]];
    return {searched_.mesh.positions[a], searched_.mesh.positions[b], searched_.mesh.positions[c]};
  }
  struct FloatPoint {
    float x, y, z;
  };
  HWY_INLINE std::array<FloatPoint, 3> float_corners_of(const Bvh8Leaf& leaf, std::uint32_t slot) const {
    const auto corner = [&](std::size_t k) {
      const std::uint8_t i = leaf.corner[k][slot];
      return FloatPoint{leaf.vertices[0][i], leaf.vertices[1][i], leaf.vertices[2][i]};
    };
    return {corner(0), corner(1), corner(2)};
  }

  const SearchedMesh& searched_;
  const PlacedRay& ray_;
  const FilterRay& filter_;
  std::optional<ClosestTriangle> closest_;
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
