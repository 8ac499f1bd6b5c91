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
  /// The farther one first. Nobody can guess which that is, so it is not a branch.
  static HWY_INLINE void sort(Entry& p, Entry& q) {
    const std::uint64_t swapped = (p.bits_ ^ q.bits_) & (0 - static_cast<std::uint64_t>(p.bits_ < q.bits_));
    p.bits_ ^= swapped;
    q.bits_ ^= swapped;
  }

 private:
  std::uint64_t bits_;
};

/// Visits the leaves that the ray may meet, roughly near to far. `Leaves` looks at their triangles:
///   bool visit(const Bvh8Leaf&, float& t_max)   t_max may be lowered, in the filter's frame; true ends the walk.
class Walk {
 public:
  HWY_INLINE Walk(const Bvh8Tree& tree, const FilterRay& filter)
      : base_(reinterpret_cast<const char*>(tree.lines.data())), filter_(filter), node_test_(filter) {}

  /// Without an order between siblings with kAny. Whether `leaves` ended it.
  template <bool kAny, class Leaves>
  HWY_INLINE bool run(Leaves& leaves, TraceCounters& counters) {
    float t_max = filter_.t_max;
    Entry* top = stack_;
    Bvh8Reference reference = 0;
    for (;;) {
      if ((reference & 1) == 0) {
        ++counters.node_visits;
        const Bvh8Node& node = *std::launder(reinterpret_cast<const Bvh8Node*>(at(reference)));
        alignas(32) std::array<float, 8> entered;
        const std::uint32_t hits = node_test_(node, entered.data());
        if (hits != 0) {
          reference = take<kAny>(node, hits, entered, top);
          continue;
        }
      } else {
        const Bvh8Leaf& leaf = *std::launder(reinterpret_cast<const Bvh8Leaf*>(at(reference) - kHalfLine));
        counters.primitive_tests += static_cast<std::uint32_t>(std::popcount(leaf.present));
        const float before = t_max;
        if (leaves.visit(leaf, t_max)) return true;
        if (t_max < before) node_test_.set_t_max(t_max);
      }
      do {
        if (top == stack_) return false;
        --top;
      } while (!(top->t() <= t_max));
      reference = top->reference();
    }
  }

 private:
  /// Returns the nearest of the hit children and puts the others on the stack, nearer ones higher; with kAny in no
  /// order. Two and three are sorted without a branch, as their order cannot be guessed. The way from the mask to the
  /// next node is kept short: all else waits for it.
  template <bool kAny>
  HWY_INLINE Bvh8Reference take(const Bvh8Node& node, std::uint32_t hits, const std::array<float, 8>& entered,
                                Entry*& top) const {
    const auto next = [&] {
      const auto slot = static_cast<std::uint32_t>(std::countr_zero(hits));
      hits &= hits - 1;
      return slot;
    };
    const auto next_entry = [&] {
      const std::uint32_t slot = next();
      return Entry(entered[slot], node.child[slot]);
    };
    if ((hits & (hits - 1)) == 0) return node.child[next()];
    if constexpr (kAny) {
      const Bvh8Reference first = node.child[next()];
      do {
        *top = next_entry();
        prefetch(*top++);
      } while (hits != 0);
      return first;
    }
    Entry a = next_entry(), b = next_entry();
    Entry::sort(a, b);
    prefetch(a);
    if (hits == 0) {
      *top++ = a;
      return b.reference();
    }
    Entry c = next_entry();
    Entry::sort(b, c);
    Entry::sort(a, b);
    prefetch(b);
    Entry* const bottom = top;
    top[0] = a;
    top[1] = b;
    top += 2;
    while (hits != 0) {
      Entry other = next_entry();
      Entry::sort(other, c);
      prefetch(other);
      Entry* place = top++;
      for (; place > bottom && place[-1] < other; --place) place[0] = place[-1];
      *place = other;
    }
    return c.reference();
  }

  /// Half a line per reference: of a leaf half a line too far, which is subtracted where it matters.
  HWY_INLINE const char* at(Bvh8Reference reference) const {
    return base_ + kHalfLine * static_cast<std::size_t>(reference);
  }
  static constexpr std::size_t kHalfLine = sizeof(CacheLine) / 2;

  HWY_INLINE void prefetch(Entry entry) const {
    __builtin_prefetch(at(entry.reference()));
    __builtin_prefetch(at(entry.reference()) + sizeof(CacheLine));
  }

  const char* base_;
  const FilterRay& filter_;
  NodeTest node_test_;
  /// At most seven entries a level, and one that is not put aside.
  Entry stack_[7 * kBvh8Deepest + 1];
};

}  // namespace HWY_NAMESPACE
}  // namespace plumb
HWY_AFTER_NAMESPACE();

#endif
