#include "renderer/accel/bvh8_walk.h"

#include <bit>
#include <cstdint>

#define HWY_DISABLED_TARGETS HWY_SSSE3  // SSE4 and the scalar baseline are enough below AVX2
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/accel/bvh8_walk.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "renderer/accel/lanes8-inl.h"
#include "renderer/accel/node_test-inl.h"

HWY_BEFORE_NAMESPACE();
namespace plumb {
namespace HWY_NAMESPACE {

/// A child and where the ray enters its box, in one number that sorts by the latter: the bits of t >= 0, then the reference.
using Entry = std::uint64_t;

HWY_INLINE float t_of(Entry entry) { return std::bit_cast<float>(static_cast<std::uint32_t>(entry >> 32)); }

class Walk {
 public:
  HWY_INLINE Walk(const Bvh8Tree& tree, const TriangleMesh& mesh, const FilterRay& ray)
      : tree_(tree), mesh_(mesh), ray_(ray), node_test_(ray), t_max_(ray.t_max) {}

  template <bool kAny>
  HWY_INLINE void run(ClosestTriangle& closest, TraceCounters& counters) {
    std::uint64_t node_visits = 0, tests = 0;
    Entry* top = stack_;
    std::uint32_t reference = 0;
    for (;;) {
      if ((reference & kBvh8Leaf) == 0) {
        ++node_visits;
        const Bvh8Node& node = tree_.nodes.data()[reference];
        alignas(32) std::array<float, 8> entered;
        const std::uint32_t hits = node_test_(node, entered.data());
        if (hits != 0) {
          reference = take<kAny>(node, hits, entered, top);
          continue;
        }
      } else {
        const Bvh8Leaf& leaf = tree_.leaves.data()[reference & ~kBvh8Leaf];
        tests += static_cast<std::uint32_t>(std::popcount(leaf.present));
        std::uint32_t candidates = test_leaf(leaf);
        if (candidates != 0) {
          do {
            ++counters.rays[0];
            offer(leaf, static_cast<std::uint32_t>(std::countr_zero(candidates)), closest);
            candidates &= candidates - 1;
          } while (candidates != 0);
          if (closest.found()) {
            if (kAny) break;
            t_max_ = ray_.frame_t_max(closest.t_max());
            node_test_.set_t_max(t_max_);
          }
        }
      }
      do {
        if (top == stack_) goto end;
        --top;
      } while (!(t_of(*top) <= t_max_));
      reference = static_cast<std::uint32_t>(*top);
    }
  end:
    counters.node_visits += node_visits;
    counters.primitive_tests += tests;
  }

 private:
  /// Returns the nearest of the hit children and puts the others on the stack, nearer ones higher; with kAny in no order. Two and three
  /// are sorted without a branch, as their order cannot be guessed. The way from the mask to the next node is kept short: all else waits for it.
  template <bool kAny>
  HWY_INLINE std::uint32_t take(const Bvh8Node& node, std::uint32_t hits, const std::array<float, 8>& entered, Entry*& top) const {
    const std::uint32_t nodes = node.nodes, first_node = node.first_node, first_leaf = node.first_leaf;
    const auto next = [&] {
      const auto slot = static_cast<std::uint32_t>(std::countr_zero(hits));
      hits &= hits - 1;
      return slot;
    };
    const auto reference = [&](std::uint32_t slot) { return slot + (slot < nodes ? first_node : first_leaf); };
    const auto entry = [&](std::uint32_t slot) {
      const auto t = std::bit_cast<std::uint32_t>(entered[slot]) & 0x7fffffff;  // -0 is 0
      return static_cast<Entry>(t) << 32 | reference(slot);
    };
    const auto sort = [](Entry& p, Entry& q) {  // the farther one first
      const Entry nearer = std::min(p, q);
      p = std::max(p, q);
      q = nearer;
    };
    const std::uint32_t first = next();
    if (hits == 0) return reference(first);
    if (kAny) {
      do {
        const Entry other = entry(next());
        prefetch(other);
        *top++ = other;
      } while (hits != 0);
      return reference(first);
    }
    Entry a = entry(first), b = entry(next());
    sort(a, b);
    if (hits == 0) {
      prefetch(a);
      *top++ = a;
      return static_cast<std::uint32_t>(b);
    }
    Entry c = entry(next());
    sort(b, c);
    sort(a, b);
    prefetch(a);
    prefetch(b);
    Entry* const bottom = top;
    top[0] = a;
    top[1] = b;
    top += 2;
    while (hits != 0) {
      Entry other = entry(next());
      sort(other, c);
      prefetch(other);
      Entry* place = top++;
      for (; place > bottom && place[-1] < other; --place) place[0] = place[-1];
      *place = other;
    }
    return static_cast<std::uint32_t>(c);
  }

  HWY_INLINE void prefetch(Entry entry) const {
    const auto reference = static_cast<std::uint32_t>(entry);
    const char* at = (reference & kBvh8Leaf) ? reinterpret_cast<const char*>(tree_.leaves.data() + (reference & ~kBvh8Leaf))
                                         : reinterpret_cast<const char*>(tree_.nodes.data() + reference);
    __builtin_prefetch(at);
    __builtin_prefetch(at + 64);
  }

  /// Which triangles of the leaf the ray may hit: all but those with the line surely on different sides of two edges.
  HWY_INLINE std::uint32_t test_leaf(const Bvh8Leaf& leaf) const {
    const Float8 ax = load8(leaf.vertices[ray_.axis[0]].data()) - all8(ray_.origin[0]);
    const Float8 ay = load8(leaf.vertices[ray_.axis[1]].data()) - all8(ray_.origin[1]);
    const Float8 az = load8(leaf.vertices[ray_.axis[2]].data()) - all8(ray_.origin[2]);
    const Float8 x = ax - all8(ray_.shear_x) * az;
    const Float8 y = ay - all8(ray_.shear_y) * az;
    const Float8 size = size_of(x) + size_of(y);
    const Lanes8 a = lanes_from(leaf.corner[0].data()), b = lanes_from(leaf.corner[1].data()),
                 c = lanes_from(leaf.corner[2].data());
    const Float8 xa = taken(x, a), xb = taken(x, b), xc = taken(x, c);
    const Float8 ya = taken(y, a), yb = taken(y, b), yc = taken(y, c);
    const Float8 sizes = (taken(size, a) + taken(size, b)) + taken(size, c);
    const Float8 u = xc * yb - yc * xb, v = xa * yc - ya * xc, w = xb * ya - yb * xa;
    const Float8 error = sizes * all8(ray_.weight_error) + all8(ray_.weight_error_constant);
    const Float8 lowest = low(low(u, v), w), highest = high(high(u, v), w);
    // Rejected: lowest < -error and highest > error.
    const std::uint32_t kept = at_most(negative(error), lowest) | at_most(highest, error);
    return kept & leaf.present;
  }

  HWY_INLINE void offer(const Bvh8Leaf& leaf, std::uint32_t slot, ClosestTriangle& closest) const {
    const std::uint32_t triangle = tree_.triangles.data()[leaf.first + slot];
    const auto vertex = [&](int k) {
      const std::uint8_t i = leaf.corner[static_cast<std::size_t>(k)][slot];
      return Point3{leaf.vertices[0][i], leaf.vertices[1][i], leaf.vertices[2][i]};
    };
    if (tree_.exact_vertices) {
      closest.offer(triangle, vertex(0), vertex(1), vertex(2));
    } else {
      const auto& [a, b, c] = mesh_.triangles[triangle];
      closest.offer(triangle, mesh_.positions[a], mesh_.positions[b], mesh_.positions[c]);
    }
  }

  const Bvh8Tree& tree_;
  const TriangleMesh& mesh_;
  const FilterRay& ray_;
  NodeTest node_test_;
  float t_max_;
  Entry stack_[7 * kBvh8Deepest + 8];
};

void walk(const Bvh8Tree& tree, const TriangleMesh& mesh, const FilterRay& ray, bool any, ClosestTriangle& closest, TraceCounters& counters) {
  Walk walk(tree, mesh, ray);
  any ? walk.run<true>(closest, counters) : walk.run<false>(closest, counters);
}

}  // namespace HWY_NAMESPACE
}  // namespace plumb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace plumb {

HWY_EXPORT(walk);

void walk_bvh8(const Bvh8Tree& tree, const TriangleMesh& mesh, FilterRay& ray, bool any, ClosestTriangle& closest, TraceCounters& counters) {
  HWY_DYNAMIC_DISPATCH(walk)(tree, mesh, ray, any, closest, counters);
}

}  // namespace plumb
#endif
