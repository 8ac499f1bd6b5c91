// The walk through a tree; included once a target.
#if defined(PLUMB_RENDERER_ACCEL_BVH8_WALK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_RENDERER_ACCEL_BVH8_WALK_INL_H
#undef PLUMB_RENDERER_ACCEL_BVH8_WALK_INL_H
#else
#define PLUMB_RENDERER_ACCEL_BVH8_WALK_INL_H
#endif

#include <bit>
#include <cstdint>
#include <new>

#include "renderer/accel/bvh8_layout.h"
#include "renderer/accel/filter_ray.h"
#include "renderer/accel/lanes8-inl.h"
#include "renderer/accel/node_test-inl.h"
#include "renderer/integrator/trace_counters.h"

HWY_BEFORE_NAMESPACE();
namespace plumb {
namespace HWY_NAMESPACE {

/// The lowest of the slots, which is taken out.
HWY_INLINE std::uint32_t taken_slot(std::uint32_t& slots) {
  const auto slot = static_cast<std::uint32_t>(std::countr_zero(slots));
  slots &= slots - 1;
  return slot;
}

/// The highest.
HWY_INLINE std::uint32_t taken_last_slot(std::uint32_t& slots) {
  const std::uint32_t slot = 31 - static_cast<std::uint32_t>(std::countl_zero(slots));
  slots ^= 1U << slot;
  return slot;
}

/// A child and where the ray enters its box, in one number that sorts by the latter: the bits of t >= 0, then the
/// reference.
class Entry {
 public:
  Entry() = default;
  HWY_INLINE Entry(float t, Bvh8Reference reference)
      : bits_(static_cast<std::uint64_t>(std::bit_cast<std::uint32_t>(t)) << 32 | reference) {}
  HWY_INLINE float t() const { return std::bit_cast<float>(static_cast<std::uint32_t>(bits_ >> 32)); }
  HWY_INLINE Bvh8Reference reference() const { return static_cast<Bvh8Reference>(bits_); }
  friend HWY_INLINE bool operator<(Entry p, Entry q) { return p.bits_ < q.bits_; }
  /// The farther one first. Nobody can guess which that is, so these are minima and maxima: no branch.
  static HWY_INLINE void sort(Entry& p, Entry& q) {
    const std::uint64_t nearer = p.bits_ < q.bits_ ? p.bits_ : q.bits_, farther = p.bits_ < q.bits_ ? q.bits_ : p.bits_;
    p.bits_ = farther;
    q.bits_ = nearer;
  }

 private:
  std::uint64_t bits_;
};

/// Visits the leaves that the ray may meet. `Leaves` looks at their triangles:
///   bool visit(const Bvh8Leaf&, float& t_max)
/// For the nearest it may lower t_max, in the filter's frame; for any it returns true to end the walk.
class Walk {
 public:
  HWY_INLINE Walk(const Bvh8Tree& tree, const FilterRay& filter, const BoxRay& boxes)
      : base_(reinterpret_cast<const char*>(tree.lines.data())), filter_(filter), node_test_(filter, boxes) {}

  /// Roughly near to far.
  template <class Leaves>
  HWY_INLINE void to_nearest(Leaves& leaves, TraceCounters& counters) {
    float t_max = filter_.range.t_max;
    Entry stack[kMostAside];  // not a member: all others may then be kept in registers
    Entry* top = stack;
    Bvh8Reference reference = 0;
    for (;;) {
      if (is_node(reference)) {
        ++counters.node_visits;
        const Bvh8Node& node = this->node(reference);
        __builtin_prefetch(&node.child);  // which line that is else shows only when the others are there
        alignas(32) std::array<float, 8> entered;
        const std::uint32_t hits = node_test_(node, entered.data());
        if (hits != 0) {
          reference = nearest(node, hits, entered, top);
          continue;
        }
      } else {
        const float before = t_max;
        leaves.visit(counted(reference, counters), t_max);
        if (t_max < before) node_test_.set_t_max(t_max);
      }
      do {
        if (top == stack) return;
        --top;
      } while (!(top->t() <= t_max));
      reference = top->reference();
    }
  }

  /// Roughly far to near, until `leaves` ends it; whether it did. Most rays of this kind leave a surface, which is what
  /// they meet first without being blocked. A node's children lie from low to high, as the builder split them.
  template <class Leaves>
  HWY_INLINE bool to_any(Leaves& leaves, TraceCounters& counters) {
    float t_max = filter_.range.t_max;
    const bool forward = filter_.reciprocal_z > 0;
    Bvh8Reference stack[kMostAside];
    Bvh8Reference* top = stack;
    Bvh8Reference reference = 0;
    for (;;) {
      if (is_node(reference)) {
        ++counters.node_visits;
        const Bvh8Node& node = this->node(reference);
        std::uint32_t hits = node_test_(node);
        if (hits != 0) {
          // A child more than is put aside, which is walked next: the farthest.
          while ((hits & (hits - 1)) != 0) *top++ = node.child[forward ? taken_slot(hits) : taken_last_slot(hits)];
          reference = node.child[taken_slot(hits)];
          continue;
        }
      } else if (leaves.visit(counted(reference, counters), t_max)) {
        return true;
      }
      if (top == stack) return false;
      reference = *--top;
    }
  }

 private:
  /// At most seven entries a level, and one that is not put aside.
  static constexpr std::size_t kMostAside = 7 * kBvh8Deepest + 1;

  static HWY_INLINE bool is_node(Bvh8Reference reference) { return (reference & 1) == 0; }
  HWY_INLINE const Bvh8Node& node(Bvh8Reference reference) const {
    return *std::launder(reinterpret_cast<const Bvh8Node*>(at(reference)));
  }
  HWY_INLINE const Bvh8Leaf& counted(Bvh8Reference reference, TraceCounters& counters) const {
    const Bvh8Leaf& leaf = *std::launder(reinterpret_cast<const Bvh8Leaf*>(at(reference) - kHalfLine));
    counters.primitive_tests += static_cast<std::uint32_t>(std::popcount(leaf.present));
    return leaf;
  }
  /// Returns the nearest of the hit children and puts the others on the stack, nearer ones higher. Two and three are
  /// sorted without a branch, as their order cannot be guessed. The way from the mask to the next node is kept short:
  /// all else waits for it.
  HWY_INLINE Bvh8Reference nearest(const Bvh8Node& node, std::uint32_t hits, const std::array<float, 8>& entered,
                                   Entry*& top) const {
    if ((hits & (hits - 1)) == 0) return node.child[taken_slot(hits)];
    const std::uint32_t all_hits = hits;
    const auto next_entry = [&] {
      const std::uint32_t slot = taken_slot(hits);
      return Entry(entered[slot], node.child[slot]);
    };
    Entry a = next_entry(), b = next_entry();
    Entry::sort(a, b);
    prefetch(a.reference());
    if (hits == 0) {
      *top++ = a;
      return b.reference();
    }
    if ((hits & (hits - 1)) == 0) {
      Entry c = next_entry();
      Entry::sort(b, c);
      Entry::sort(a, b);
      prefetch(b.reference());
      top[0] = a;
      top[1] = b;
      top += 2;
      return c.reference();
    }
    return nearest_of_many(node, all_hits, entered, top);
  }

  /// Each goes to its place by how many are nearer, as where it belongs cannot be guessed either.
  HWY_INLINE Bvh8Reference nearest_of_many(const Bvh8Node& node, std::uint32_t hits,
                                           const std::array<float, 8>& entered, Entry*& top) const {
    const Float8 near = told_apart(load8(entered.data()));
    alignas(32) std::array<float, 8> keys;
    store8(near, keys.data());
    const auto count = static_cast<std::uint32_t>(std::popcount(hits));
    for (std::uint32_t rest = hits; rest != 0;) {
      const std::uint32_t slot = taken_slot(rest);
      const auto not_farther = static_cast<std::uint32_t>(std::popcount(at_most(near, all8(keys[slot])) & hits));
      const Bvh8Reference reference = node.child[slot];
      prefetch(reference);
      top[count - not_farther] = Entry(entered[slot], reference);
    }
    top += count - 1;
    return top->reference();
  }

  /// Half a line per reference: of a leaf half a line too far, which is subtracted where it matters.
  HWY_INLINE const char* at(Bvh8Reference reference) const {
    return base_ + kHalfLine * static_cast<std::size_t>(reference);
  }
  static constexpr std::size_t kHalfLine = sizeof(CacheLine) / 2;

  HWY_INLINE void prefetch(Bvh8Reference reference) const {
    for (std::size_t line = 0; line < sizeof(Bvh8Node) / sizeof(CacheLine); ++line)
      __builtin_prefetch(at(reference) + line * sizeof(CacheLine));
  }

  const char* base_;
  const FilterRay& filter_;
  NodeTest node_test_;
};

}  // namespace HWY_NAMESPACE
}  // namespace plumb
HWY_AFTER_NAMESPACE();

#endif
