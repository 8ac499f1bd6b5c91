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
  HWY_INLINE NodeTest(const FilterRay& ray, const BoxRay& boxes)
      : NodeTest(ray, boxes.reciprocal, boxes.near_origin * boxes.reciprocal, boxes.far_origin * boxes.reciprocal) {}

  HWY_INLINE void set_t_max(float t_max) { t_max_ = all8(t_max); }

  /// A bit for each child whose box the ray may meet, and where it does so at the earliest, eight numbers.
  HWY_INLINE std::uint32_t operator()(const Bvh8Node& node, float* entered) const {
    return test(node, [&](Float8 near) { store8(near, entered); });
  }
  HWY_INLINE std::uint32_t operator()(const Bvh8Node& node) const {
    return test(node, [](Float8) {});
  }

 private:
  HWY_INLINE NodeTest(const FilterRay& ray, BoxSide reciprocal, BoxSide near, BoxSide far)
      : ray_(ray),
        x_{all8(reciprocal[0]), all8(near[0]), all8(far[0])},
        y_{all8(reciprocal[1]), all8(near[1]), all8(far[1])},
        z_{all8(reciprocal[2]), all8(near[2]), all8(far[2])},
        t_min_(all8(ray.range.t_min)),
        t_max_(all8(ray.range.t_max)) {}

  template <class Entered>
  HWY_INLINE std::uint32_t test(const Bvh8Node& node, const Entered& entered) const {
    const Sides x = sides(node, x_, 0), y = sides(node, y_, 1), z = sides(node, z_, 2);
    const Float8 near = high(high(x.near, y.near), high(z.near, t_min_));
    const Float8 far = low(low(x.far, y.far), low(z.far, t_max_));
    entered(near);
    return at_most(near, far);
  }

  struct Sides {
    Float8 near, far;
  };
  struct Axis {
    Float8 reciprocal, near_origin, far_origin;
  };
  HWY_INLINE Sides sides(const Bvh8Node& node, const Axis& axis, int i) const {
    const auto* const rows = reinterpret_cast<const std::byte*>(&node.sides[static_cast<std::size_t>(i)]);
    const auto row = [&](std::int32_t offset) {
      return load8(reinterpret_cast<const float*>(rows + static_cast<std::uint32_t>(offset)));
    };
    return {product_less(row(ray_.near_offset[i]), axis.reciprocal, axis.near_origin),
            product_less(row(ray_.far_offset[i]), axis.reciprocal, axis.far_origin)};
  }

  const FilterRay& ray_;
  Axis x_, y_, z_;
  Float8 t_min_, t_max_;
};

}  // namespace HWY_NAMESPACE
}  // namespace plumb
HWY_AFTER_NAMESPACE();

#endif
