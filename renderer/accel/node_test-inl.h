// The test of a ray against the eight boxes of a node; included once a target.
#if defined(PLUMB_RENDERER_ACCEL_NODE_TEST_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_RENDERER_ACCEL_NODE_TEST_INL_H
#undef PLUMB_RENDERER_ACCEL_NODE_TEST_INL_H
#else
#define PLUMB_RENDERER_ACCEL_NODE_TEST_INL_H
#endif

#include "renderer/accel/bvh8_layout.h"
#include "renderer/accel/filter_ray.h"
#include "renderer/accel/lanes8-inl.h"

HWY_BEFORE_NAMESPACE();
namespace plumb {
namespace HWY_NAMESPACE {

class NodeTest {
 public:
  HWY_INLINE explicit NodeTest(const FilterRay& ray)
      : x_(ray, 0), y_(ray, 1), z_(ray, 2), t_min_(all8(ray.t_min)), t_max_(all8(ray.t_max)) {}

  HWY_INLINE void set_t_max(float t_max) { t_max_ = all8(t_max); }

  /// A bit for each child whose box the ray may meet, and where it does so at the earliest, eight numbers.
  HWY_INLINE std::uint32_t operator()(const Bvh8Node& node, float* entered) const {
    return test(node, [&](Float8 near) { store8(near, entered); });
  }
  HWY_INLINE std::uint32_t operator()(const Bvh8Node& node) const {
    return test(node, [](Float8) {});
  }

 private:
  template <class Entered>
  HWY_INLINE std::uint32_t test(const Bvh8Node& node, const Entered& entered) const {
    const Sides x = x_.sides(node, 0), y = y_.sides(node, 1), z = z_.sides(node, 2);
    const Float8 near = high(high(x.near, y.near), high(z.near, t_min_));
    const Float8 far = low(low(x.far, y.far), low(z.far, t_max_));
    entered(near);
    return at_most(near, far);
  }

  struct Sides {
    Float8 near, far;
  };

  class Axis {
   public:
    HWY_INLINE Axis(const FilterRay& ray, int axis)
        : reciprocal_(all8(ray.reciprocal[axis])),
          near_origin_(all8(ray.near_origin[axis] * ray.reciprocal[axis])),
          far_origin_(all8(ray.far_origin[axis] * ray.reciprocal[axis])),
          near_(8 * static_cast<std::size_t>(ray.near_row[axis])),
          far_(8 - near_) {}
    HWY_INLINE Sides sides(const Bvh8Node& node, std::size_t axis) const {
      const float* const rows = node.sides[axis][0].data();
      return {product_less(load8(rows + near_), reciprocal_, near_origin_),
              product_less(load8(rows + far_), reciprocal_, far_origin_)};
    }

   private:
    Float8 reciprocal_, near_origin_, far_origin_;
    /// Where the near and the far sides begin in those of an axis.
    std::size_t near_, far_;
  };

  Axis x_, y_, z_;
  Float8 t_min_, t_max_;
};

}  // namespace HWY_NAMESPACE
}  // namespace plumb
HWY_AFTER_NAMESPACE();

#endif
