#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "renderer/integrator/trace_counters.h"
#include "renderer/math/bounds3.h"
#include "renderer/math/ray.h"

namespace plumb {

/// The reciprocal of a ray's direction, and the slab test with it.
struct SlabTest {
  /// The box is wider by `margin` times the origin's largest coordinate, and by `drift`.
  explicit SlabTest(const Ray& ray, double margin = kMargin, double drift = 0);

  /// Whether the ray, within [t_min, t_max], may pass through the closed box. Never wrongly false: the box is widened
  /// by `margin` times the origin's largest coordinate, so that the rounding of a primitive's own test, which grows
  /// with the distance, does not make it reach out of its box; the far distance by 1 + 2 gamma_3 [Ize 2013]; and the
  /// NaN of a ray that runs within a face (0 times infinity) changes nothing.
  bool may_hit(const Bounds3& box, double t_min, double t_max) const {
    double near = t_min;
    double far = t_max;
    for (int axis = 0; axis < 3; ++axis) {
      const double a = (box.min[axis] - origin_above[axis]) * reciprocal[axis];
      const double b = (box.max[axis] - origin_below[axis]) * reciprocal[axis];
      const double enter = negative[static_cast<std::size_t>(axis)] ? b : a;
      const double leave = (negative[static_cast<std::size_t>(axis)] ? a : b) * kWiden;
      if (enter > near) near = enter;
      if (leave < far) far = leave;
    }
    return near <= far;
  }

  /// 2^12 times the rounding of the coordinates themselves: well above the errors of the primitives' tests, and far too
  /// little to cost anything.
  static constexpr double kMargin = 0x1p-40;

  // gamma_3 = 3u / (1 - 3u) with u = 2^-53, so 1 + 2 gamma_3 lies between 1 + 6u and 1 + 8u, which is a double.
  static constexpr double kWiden = 1 + 8 * 0x1p-53;

  /// The origin plus and minus the margin: the same as a wider box.
  Point3 origin_above, origin_below;
  Vec3 reciprocal;
  std::array<bool, 3> negative;
};

/// The largest magnitude of a coordinate of the box, which is not empty.
double largest_coordinate(const Bounds3& box);

/// The box, larger on every axis by `margin` times its largest coordinate; empty for an empty one.
Bounds3 widened(const Bounds3& box, double margin);

/// A binary bounding volume hierarchy over numbered boxes, built by the surface area heuristic over 16 bins
/// [Wald 2007]. The readable one: later hierarchies are measured against it.
class Hierarchy {
 public:
  /// Over primitives 0 .. bounds.size() - 1. Empty boxes are never visited. The boxes are widened on every axis by
  /// SlabTest::kMargin of their largest coordinate, for the same reason as in SlabTest, which gets `origin_margin`:
  /// larger where the primitives' tests have larger errors.
  explicit Hierarchy(std::span<const Bounds3> bounds, double origin_margin = SlabTest::kMargin);

  /// Calls visit(primitive) for each primitive whose box the ray may pass through, roughly near to far. `visit`
  /// may lower ray.t_max, which prunes what lies strictly beyond it, and stops the walk by returning true;
  /// then so does this. `drift` is how far the ray may pass from the one that is meant, anywhere near the primitives
  /// (PlacedRay::drift).
  template <class Visit>
  bool walk(const Ray& ray, TraceCounters& counters, Visit&& visit, double drift = 0) const {
    if (nodes_.empty()) return false;
    const SlabTest slab(ray, origin_margin_, drift);
    std::array<std::uint32_t, kDeepest + 1> stack;
    std::size_t depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
      const Node& node = nodes_[stack[--depth]];
      ++counters.node_visits;
      if (!slab.may_hit(node.bounds, ray.t_min, ray.t_max)) continue;
      if (node.count > 0) {
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
          if (visit(order_[i])) return true;
        continue;
      }
      std::uint32_t near = node.first;
      std::uint32_t far = node.first + 1;
      if (slab.negative[node.axis]) std::swap(near, far);
      stack[depth++] = far;
      stack[depth++] = near;
    }
    return false;
  }

  std::size_t node_count() const { return nodes_.size(); }
  int depth() const { return depth_; }

  /// No path is longer: below kBalanced levels nodes are halved by count instead.
  static constexpr std::size_t kDeepest = 96;
  static constexpr int kBalanced = 60;

 private:
  /// An inner node has its children at first and first + 1; a leaf has `count` primitives from order_[first].
  struct Node {
    Bounds3 bounds;
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    std::uint32_t axis = 0;
  };
  friend class HierarchyBuilder;

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
  double origin_margin_;
  int depth_ = 0;
};

}  // namespace plumb
