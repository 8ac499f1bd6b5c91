#include "renderer/accel/binned_split.h"

namespace plumb {
namespace {

/// What testing so many triangles costs: leaves of about five, and something for each. Whole sixths, rounded up.
[[gnu::always_inline]] inline BoxSide cost_of(BoxCounts counts) {
  const BoxSide sixths = __builtin_convertvector(counts + 5, BoxSide) * (1.0F / 6);
  return __builtin_convertvector(__builtin_convertvector(sixths, BoxCounts), BoxSide);
}

}  // namespace

[[gnu::always_inline]] inline void BoxBins::add_one(const TriangleGroup& group, const Binning& binning) {
  const FloatBox box = group.bounds();
  const BoxCounts place = binning.of(box);
  const auto x = static_cast<std::size_t>(place[0]), y = static_cast<std::size_t>(place[1]),
             z = static_cast<std::size_t>(place[2]);
  boxes_[x].x.extend(box);
  boxes_[y].y.extend(box);
  boxes_[z].z.extend(box);
  const auto count = static_cast<std::int32_t>(group.count());
  counts_[x][0] += count;
  counts_[y][1] += count;
  counts_[z][2] += count;
}

void BoxBins::add(std::span<const TriangleGroup> groups, const Binning& binning) {
  // Neighbours fall into the same bins, and each would wait for the one before; so those far apart take turns.
  constexpr std::size_t kMany = 256;
  std::size_t i = 0;
  if (groups.size() >= kMany) {
    const std::size_t half = groups.size() / 2;
    BoxBins others(static_cast<int>(bins_));
    for (; i < half; ++i) {
      add_one(groups[i], binning);
      others.add_one(groups[half + i], binning);
    }
    append(others);
    i = 2 * half;
  }
  for (; i < groups.size(); ++i) add_one(groups[i], binning);
}

void BoxBins::append(const BoxBins& others) {
  for (std::size_t bin = 0; bin < bins_; ++bin) {
    boxes_[bin].extend(others.boxes_[bin]);
    counts_[bin] += others.counts_[bin];
  }
}

// The three axes are looked at side by side.
BinnedSplit BoxBins::best_split(std::uint32_t triangles) const {
  constexpr BoxSide kNone{};
  std::array<BoxSide, kMostBins> right_cost;
  Boxes right, left;
  BoxCounts on_right{}, on_left{};
  for (std::size_t bin = bins_ - 1; bin > 0; --bin) {
    right.extend(boxes_[bin]);
    on_right += counts_[bin];
    right_cost[bin] = on_right > 0 ? right.half_areas() * cost_of(on_right) : kNone;
  }
  const BoxCounts all = BoxCounts{} + static_cast<std::int32_t>(triangles);
  BoxSide least = kNone + std::numeric_limits<float>::infinity();
  BoxCounts least_bin{};
  for (std::size_t bin = 1; bin < bins_; ++bin) {
    left.extend(boxes_[bin - 1]);
    on_left += counts_[bin - 1];
    const BoxSide cost = left.half_areas() * cost_of(on_left) + right_cost[bin];
    const BoxCounts is_better = (on_left != 0) & (on_left != all) & (cost < least);
    least = is_better ? cost : least;
    least_bin = is_better ? BoxCounts{} + static_cast<std::int32_t>(bin) : least_bin;
  }
  BinnedSplit best;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(least[axis] < best.cost)) continue;
    best.cost = least[axis];
    best.axis = axis;
    best.bin = least_bin[axis];
  }
  for (int bin = 0; bin < static_cast<int>(bins_); ++bin) {
    const auto i = static_cast<std::size_t>(bin);
    (bin < best.bin ? best.left : best.right).extend(boxes_[i].of(best.axis));
    if (bin < best.bin) best.left_triangles += static_cast<std::uint32_t>(counts_[i][best.axis]);
  }
  return best;
}

}  // namespace plumb
