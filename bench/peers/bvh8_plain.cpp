#include "bench/peers/bvh8_plain.h"

#include <bit>

#include "bench/peers/plain_test.h"

#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bench/peers/bvh8_plain.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "renderer/accel/bvh8_walk-inl.h"

HWY_BEFORE_NAMESPACE();
namespace plumb {
namespace HWY_NAMESPACE {

template <bool kAny>
class PlainLeaves {
 public:
  HWY_INLINE PlainLeaves(const Bvh8Tree& tree, const FilterRay& filter, const Ray& ray)
      : tree_(tree), filter_(filter), rest_(ray), test_(rest_) {}

  HWY_INLINE bool visit(const Bvh8Leaf& leaf, float& t_max) {
    for (std::uint32_t slot = 0; slot < static_cast<std::uint32_t>(std::popcount(leaf.present)); ++slot) {
      const auto corner = [&](std::size_t k) {
        const std::uint8_t i = leaf.corner[k][slot];
        return Point3{leaf.vertices[0][i], leaf.vertices[1][i], leaf.vertices[2][i]};
      };
      const auto t = test_(corner(0), corner(1), corner(2));
      if (!t) continue;
      if constexpr (kAny) return true;
      const std::uint32_t triangle = tree_.triangles[leaf.first + slot];
      if (found_.hit() && *t == found_.t && triangle > found_.triangle) continue;
      found_ = {*t, triangle};
      rest_.t_max = *t;
      t_max = filter_.frame_t_max(*t);
    }
    return false;
  }

  HWY_INLINE bench::Found found() const { return found_; }

 private:
  const Bvh8Tree& tree_;
  const FilterRay& filter_;
  Ray rest_;
  bench::PlainTest test_;
  bench::Found found_;
};

bench::Found plain_closest(const Bvh8Tree& tree, const Ray& ray, const FilterRay& filter, const BoxRay& boxes) {
  TraceCounters counters;
  PlainLeaves<false> leaves(tree, filter, ray);
  Walk(tree, filter, boxes).to_nearest(leaves, counters);
  return leaves.found();
}

bool plain_any(const Bvh8Tree& tree, const Ray& ray, const FilterRay& filter, const BoxRay& boxes) {
  TraceCounters counters;
  PlainLeaves<true> leaves(tree, filter, ray);
  return Walk(tree, filter, boxes).to_any(leaves, counters);
}

}  // namespace HWY_NAMESPACE
}  // namespace plumb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace plumb {

HWY_EXPORT(plain_closest);
HWY_EXPORT(plain_any);

namespace bench {

Found plain_closest(const Bvh8Tree& tree, const Ray& ray) {
  FilterRay filter;
  BoxRay boxes;
  if (make_filter_ray(PlacedRay(ray), tree.frame, filter, boxes) != FilterRay::Fate::walk) return {};
  return HWY_DYNAMIC_DISPATCH(plumb::plain_closest)(tree, ray, filter, boxes);
}

bool plain_any(const Bvh8Tree& tree, const Ray& ray) {
  FilterRay filter;
  BoxRay boxes;
  if (make_filter_ray(PlacedRay(ray), tree.frame, filter, boxes) != FilterRay::Fate::walk) return false;
  return HWY_DYNAMIC_DISPATCH(plumb::plain_any)(tree, ray, filter, boxes);
}

}  // namespace bench
}  // namespace plumb
#endif
