#include "renderer/accel/binary_tree.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <future>
#include <limits>

#include "renderer/accel/bvh8_layout.h"

namespace plumb {
namespace {

constexpr int kBins = 16;
/// Below so many levels, nodes are halved by count, so that paths stay short: 2^32 triangles have 32 levels more.
constexpr int kBalanced = 60;
/// A subtree of fewer triangles is not worth a thread.
constexpr std::uint32_t kWorthAThread = 4096;

/// What testing so many triangles costs: leaves of about five, and something for each.
float cost_of(std::uint32_t count) { return static_cast<float>((count + 5) / 6); }

/// Twice the centre. The fourth lanes, whose bits are no number, are left out: as floats most would be subnormal, and
/// slow.
BoxSide center_of(const FloatBox& box) {
  using Bits = std::int32_t __attribute__((vector_size(16)));
  constexpr Bits kThree{-1, -1, -1, 0};
  return std::bit_cast<BoxSide>(std::bit_cast<Bits>(box.low) & kThree) +
         std::bit_cast<BoxSide>(std::bit_cast<Bits>(box.high) & kThree);
}

/// Groups from begin to end, and how many triangles they have together.
struct Range {
  std::uint32_t begin, end;
  std::uint32_t triangles = 0;
  FloatBox box{}, centers{};
  std::uint32_t count() const { return end - begin; }
  void add(const TriangleGroup& group) {
    box.extend(group.box);
    centers.extend(center_of(group.box));
    triangles += group.count();
  }
};

struct Bins {
  std::array<std::array<FloatBox, kBins>, 3> boxes;
  std::array<std::array<std::uint32_t, kBins>, 3> counts{};
};

struct Split {
  float cost = std::numeric_limits<float>::infinity();
  std::size_t axis = 0;
  int bin = 0;  // the first on the right
};

/// Which bin a centre falls into, on each axis.
class Binning {
 public:
  explicit Binning(const FloatBox& centers) : low_(centers.low) {
    const BoxSide extent = centers.high - centers.low;
    for (int axis = 0; axis < 3; ++axis) {
      const float scale = 0.9999F * kBins / extent[axis];
      scale_[axis] = extent[axis] > 0 && scale < FloatBox::kFar ? scale : 0;
    }
  }
  bool splits(std::size_t axis) const { return scale_[static_cast<int>(axis)] > 0; }
  using Places = std::int32_t __attribute__((vector_size(16)));
  Places of(const FloatBox& box) const { return __builtin_convertvector((center_of(box) - low_) * scale_, Places); }

 private:
  BoxSide low_;
  BoxSide scale_{};
};

class BinaryBuilder {
 public:
  BinaryBuilder(const ListedTriangles& listed, std::span<TriangleGroup> groups, int threads)
      : listed_(listed), groups_(groups), nodes_(2 * groups.size()), helpers_(threads - 1) {}

  MappedArray<BinaryNode> build() {
    Range all{0, static_cast<std::uint32_t>(groups_.size())};
    for (const TriangleGroup& group : groups_) all.add(group);
    build_node(0, all, 1);
    nodes_.shrink(used_);
    return std::move(nodes_);
  }

 private:
  void build_node(std::uint32_t index, const Range& range, int depth) {
    BinaryNode& node = nodes_[index];
    node.box = range.box;
    if (fits_a_leaf(range)) {
      node.first = range.begin;
      node.count = range.count();
      node.cost.fill(0);
      node.split.fill(0);
      return;
    }
    const auto [left, right] = split(range, depth);
    const std::uint32_t first = used_.fetch_add(2, std::memory_order_relaxed);
    node.first = first;
    node.count = 0;
    if (std::min(left.count(), right.count()) >= kWorthAThread && helpers_.fetch_sub(1) > 0) {
      auto other = std::async(std::launch::async, [&] {
        build_node(first + 1, right, depth + 1);
        helpers_.fetch_add(1);
      });
      build_node(first, left, depth + 1);
      other.get();
    } else {
      if (std::min(left.count(), right.count()) >= kWorthAThread) helpers_.fetch_add(1);
      build_node(first, left, depth + 1);
      build_node(first + 1, right, depth + 1);
    }
    set_costs(node, nodes_[first], nodes_[first + 1]);
  }

  bool fits_a_leaf(const Range& range) const {
    if (range.triangles > kLeafTriangles) return false;
    std::array<std::uint32_t, kLeafVertices> seen;
    std::size_t count = 0;
    for (const TriangleGroup& group : groups_.subspan(range.begin, range.count())) {
      for (const std::uint32_t triangle : listed_.triangles.subspan(group.first(), group.count())) {
        for (const std::uint32_t vertex : listed_.mesh.triangles[triangle]) {
          if (std::find(seen.begin(), seen.begin() + count, vertex) != seen.begin() + count) continue;
          if (count == kLeafVertices) return false;
          seen[count++] = vertex;
        }
      }
    }
    return true;
  }

  static void set_costs(BinaryNode& node, const BinaryNode& left, const BinaryNode& right) {
    for (std::size_t room = 2; room <= 8; ++room) {
      float least = std::numeric_limits<float>::infinity();
      std::size_t split = 1;
      for (std::size_t on_left = 1; on_left < room; ++on_left) {
        const float cost = left.cost[on_left - 1] + right.cost[room - on_left - 1];
        if (cost < least) {
          least = cost;
          split = on_left;
        }
      }
      node.cost[room - 1] = least;
      node.split[room - 1] = static_cast<std::uint8_t>(split);
    }
    // As a wide node of its own.
    node.cost[0] = node.box.half_area() + node.cost[7];
    node.split[0] = 0;
    for (std::size_t room = 2; room <= 7; ++room) {
      if (node.cost[0] > node.cost[room - 1]) continue;
      node.cost[room - 1] = node.cost[0];
      node.split[room - 1] = 0;
    }
  }

  std::pair<Range, Range> split(const Range& range, int depth) {
    const Binning binning(range.centers);
    const Split best = depth < kBalanced ? best_split(range, binning) : Split{};
    if (best.cost == std::numeric_limits<float>::infinity()) return halves(range);
    return partition(range, binning, best);
  }

  Split best_split(const Range& range, const Binning& binning) const {
    Bins bins;
    for (std::uint32_t i = range.begin; i < range.end; ++i) {
      const TriangleGroup& group = groups_[i];
      const auto place = binning.of(group.box);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto bin = static_cast<std::size_t>(place[static_cast<int>(axis)]);
        bins.boxes[axis][bin].extend(group.box);
        bins.counts[axis][bin] += group.count();
      }
    }
    Split best;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (binning.splits(axis)) improve(best, bins, axis, range.triangles);
    return best;
  }

  static void improve(Split& best, const Bins& bins, std::size_t axis, std::uint32_t count) {
    std::array<float, kBins> right_cost;
    FloatBox right;
    std::uint32_t on_right = 0;
    for (int b = kBins - 1; b > 0; --b) {
      const auto bin = static_cast<std::size_t>(b);
      right.extend(bins.boxes[axis][bin]);
      on_right += bins.counts[axis][bin];
      right_cost[bin] = on_right ? right.half_area() * cost_of(on_right) : 0;
    }
    FloatBox left;
    std::uint32_t on_left = 0;
    for (int b = 1; b < kBins; ++b) {
      const auto bin = static_cast<std::size_t>(b);
      left.extend(bins.boxes[axis][bin - 1]);
      on_left += bins.counts[axis][bin - 1];
      if (on_left == 0 || on_left == count) continue;
      const float cost = left.half_area() * cost_of(on_left) + right_cost[bin];
      if (cost < best.cost) best = {cost, axis, b};
    }
  }

  std::pair<Range, Range> partition(const Range& range, const Binning& binning, const Split& split) {
    Range left{range.begin, range.begin}, right{range.end, range.end};
    std::uint32_t i = range.begin, end = range.end;
    while (i < end) {
      const TriangleGroup& group = groups_[i];
      if (binning.of(group.box)[static_cast<int>(split.axis)] < split.bin) {
        left.add(group);
        ++i;
      } else {
        right.add(group);
        std::swap(groups_[i], groups_[--end]);
      }
    }
    left.end = right.begin = i;
    return {left, right};
  }

  /// Where no plane parts the centres, any half is as good as another.
  std::pair<Range, Range> halves(const Range& range) {
    const std::uint32_t middle = range.begin + range.count() / 2;
    Range left{range.begin, middle}, right{middle, range.end};
    for (Range* half : {&left, &right})
      for (std::uint32_t i = half->begin; i < half->end; ++i) half->add(groups_[i]);
    return {left, right};
  }

  const ListedTriangles& listed_;
  std::span<TriangleGroup> groups_;
  MappedArray<BinaryNode> nodes_;
  std::atomic<std::uint32_t> used_ = 1;
  std::atomic<int> helpers_;
};

}  // namespace

MappedArray<BinaryNode> build_binary_tree(const ListedTriangles& listed, std::span<TriangleGroup> groups, int threads) {
  return BinaryBuilder(listed, groups, threads).build();
}

}  // namespace plumb
