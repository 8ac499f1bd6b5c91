#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "conformance/envelopes/textbook/arithmetic.h"

namespace plumb::textbook {

/// A closed box with sides along the axes; empty at first.
template <class A>
struct Bounds {
  using Real = RealOf<A>;
  static constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
  Vector<A> min{kInfinity, kInfinity, kInfinity}, max{-kInfinity, -kInfinity, -kInfinity};

  void extend(const Vector<A>& p) { min = lower(min, p), max = upper(max, p); }
  void extend(const Bounds& b) { min = lower(min, b.min), max = upper(max, b.max); }

  Bounds widened(Real by) const {
    const Vector<A> room{by, by, by};
    return {min - room, max + room};
  }

  /// Where the ray's range enters the box, or infinity where it does not. The far distances are lengthened by more than
  /// their rounding [Ize 2013], and the comparisons pass over the NaN of a ray that runs within a face.
  Real entry(const Ray<A>& ray) const {
    constexpr Real kLonger = 1 + 4 * std::numeric_limits<Real>::epsilon();
    Real start = ray.t_min, end = ray.t_max;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Real near = (min[axis] - ray.origin[axis]) / ray.direction[axis];
      Real far = (max[axis] - ray.origin[axis]) / ray.direction[axis];
      if (ray.direction[axis] < 0) std::swap(near, far);
      if (near > start) start = near;
      if (far * kLonger < end) end = far * kLonger;
    }
    return start <= end ? start : kInfinity;
  }
};

/// A binary tree of boxes, each list of primitives cut at the median of the centres along the longest side.
template <class A>
class Hierarchy {
  using Real = RealOf<A>;

 public:
  Hierarchy() = default;
  explicit Hierarchy(std::span<const Bounds<A>> bounds) : order_(bounds.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    if (!order_.empty()) build(bounds, 0, static_cast<std::uint32_t>(order_.size()));
  }

  /// Calls visit(primitive) for each whose box the ray may meet, about from near to far, until it answers true, and
  /// returns whether it did. `visit` may lower ray.t_max on the way: what lies strictly beyond is passed over.
  template <class Visit>
  bool walk(const Ray<A>& ray, Visit&& visit) const {
    if (nodes_.empty()) return false;
    std::array<std::uint32_t, kDeepest> stack;
    std::size_t waiting = 0;
    stack[waiting++] = 0;
    while (waiting > 0) {
      const Node& node = nodes_[stack[--waiting]];
      if (node.bounds.entry(ray) == Bounds<A>::kInfinity) continue;
      if (node.count > 0) {
        for (std::uint32_t i = 0; i < node.count; ++i)
          if (visit(order_[node.first + i])) return true;
        continue;
      }
      const auto left = static_cast<std::uint32_t>(&node - nodes_.data()) + 1;
      const bool left_is_near = ray.direction[node.axis] >= 0;
      stack[waiting++] = left_is_near ? node.first : left;
      stack[waiting++] = left_is_near ? left : node.first;
    }
    return false;
  }

 private:
  /// Halving 2^32 primitives gives 32 levels, and each keeps one node waiting.
  static constexpr std::size_t kDeepest = 64;
  static constexpr std::uint32_t kLeaf = 4;

  /// A leaf has `count` primitives from `first` on; an inner node its left child next to it, its right one at `first`.
  struct Node {
    Bounds<A> bounds;
    std::uint32_t first = 0, count = 0, axis = 0;
  };

  void build(std::span<const Bounds<A>> bounds, std::uint32_t begin, std::uint32_t end) {
    const std::size_t self = nodes_.size();
    Node node;
    Bounds<A> centers;
    for (std::uint32_t i = begin; i < end; ++i) {
      node.bounds.extend(bounds[order_[i]]);
      centers.extend(twice_center(bounds[order_[i]]));
    }
    const Vector<A> sides = centers.max - centers.min;
    node.axis = sides.x >= sides.y && sides.x >= sides.z ? 0 : sides.y >= sides.z ? 1 : 2;
    nodes_.push_back(node);
    if (end - begin <= kLeaf) {
      nodes_[self].first = begin, nodes_[self].count = end - begin;
      return;
    }
    const std::uint32_t middle = begin + (end - begin) / 2;
    // Equal centres by their number, so that the halves are the same with every library.
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) {
                       const Real of_a = twice_center(bounds[a])[node.axis], of_b = twice_center(bounds[b])[node.axis];
                       return of_a != of_b ? of_a < of_b : a < b;
                     });
    build(bounds, begin, middle);
    nodes_[self].first = static_cast<std::uint32_t>(nodes_.size());
    build(bounds, middle, end);
  }

  static Vector<A> twice_center(const Bounds<A>& b) { return b.min + b.max; }

  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace plumb::textbook
