#include "renderer/accel/group_partition.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <vector>

namespace plumb {
namespace {

/// Ranges of so many groups are looked at in slices, whose number does not depend on that of threads.
constexpr std::uint32_t kSliced = 16384;
constexpr std::uint32_t kSlices = 16;

/// The centres on both sides of a plane, and how many groups there are below it.
struct Sides {
  std::uint32_t below = 0;
  FloatBox left_centers{}, right_centers{};
  void append(const Sides& other) {
    below += other.below;
    left_centers.extend(other.left_centers);
    right_centers.extend(other.right_centers);
  }
};

/// Grows the box where `leave_out` is zero. Where it is all ones the point becomes NaN, which no comparison takes.
void extend_unless(FloatBox& box, BoxCounts point, BoxCounts leave_out) {
  const BoxSide p = std::bit_cast<BoxSide>(point | leave_out);
  box.low = lower_of(p, box.low);
  box.high = higher_of(p, box.high);
}

/// Moves those below the plane to the front, without branches, as which side a group is on cannot be guessed: each is
/// exchanged with the first that is not below.
template <int kAxis>
Sides part_along(std::span<TriangleGroup> groups, const Binning& binning, int bin) {
  Sides sides;
  for (TriangleGroup& at : groups) {
    const TriangleGroup group = at;
    const BoxSide center = center_of(group.bounds());
    const BoxCounts on_axes = binning.below(center, bin);
    const BoxCounts below = __builtin_shufflevector(on_axes, on_axes, kAxis, kAxis, kAxis, kAxis);
    extend_unless(sides.left_centers, std::bit_cast<BoxCounts>(center), ~below);
    extend_unless(sides.right_centers, std::bit_cast<BoxCounts>(center), below);
    at = groups[sides.below];
    groups[sides.below] = group;
    sides.below -= static_cast<std::uint32_t>(below[0]);  // all ones are -1
  }
  return sides;
}

Sides part(std::span<TriangleGroup> groups, const Binning& binning, const BinnedSplit& split) {
  if (split.axis == 0) return part_along<0>(groups, binning, split.bin);
  if (split.axis == 1) return part_along<1>(groups, binning, split.bin);
  return part_along<2>(groups, binning, split.bin);
}

/// A range of groups in slices.
class SlicedRange {
 public:
  SlicedRange(std::span<TriangleGroup> groups, WorkerPool& pool) : groups_(groups), pool_(pool) {}

  BinnedSplit best_split(const Binning& binning, std::uint32_t triangles) const {
    std::vector<BoxBins> bins(kSlices, BoxBins(kMostBins));
    pool_.each(kSlices, [&](std::size_t i) { bins[i].add(slice(i), binning); });
    for (std::size_t i = 1; i < kSlices; ++i) bins[0].append(bins[i]);
    return bins[0].best_split(triangles);
  }

  Sides part(const Binning& binning, const BinnedSplit& split) const {
    std::array<Sides, kSlices> slices;
    pool_.each(kSlices, [&](std::size_t i) { slices[i] = plumb::part(slice(i), binning, split); });
    Sides all;
    for (const Sides& sides : slices) all.append(sides);
    exchange(slices, all.below);
    return all;
  }

 private:
  std::size_t begin_of(std::size_t i) const { return groups_.size() * i / kSlices; }
  std::span<TriangleGroup> slice(std::size_t i) const {
    return groups_.subspan(begin_of(i), begin_of(i + 1) - begin_of(i));
  }

  /// Each slice is parted; exchanges what is above before `middle` with what is below behind it, in order.
  void exchange(const std::array<Sides, kSlices>& slices, std::size_t middle) const {
    Runs above, below;
    for (std::size_t i = 0; i < kSlices; ++i) {
      const std::size_t begin = begin_of(i), parted = begin + slices[i].below, end = begin_of(i + 1);
      above.add(parted, std::min(end, middle));
      below.add(std::max(begin, middle), parted);
    }
    pool_.each(kSlices, [&](std::size_t i) {
      std::size_t k = above.total * i / kSlices;
      const std::size_t end = above.total * (i + 1) / kSlices;
      while (k < end) {
        const auto [a, most_a] = above.find(k);
        const auto [b, most_b] = below.find(k);
        const std::size_t length = std::min({most_a, most_b, end - k});
        std::swap_ranges(&groups_[a], &groups_[a] + length, &groups_[b]);
        k += length;
      }
    });
  }

  /// Places that are counted through, run by run.
  struct Runs {
    std::array<std::size_t, kSlices> begins, lengths;
    std::size_t runs = 0, total = 0;
    void add(std::size_t begin, std::size_t end) {
      if (begin >= end) return;
      begins[runs] = begin;
      lengths[runs++] = end - begin;
      total += end - begin;
    }
    /// The k-th place, and how many follow it in its run, itself among them.
    std::pair<std::size_t, std::size_t> find(std::size_t k) const {
      std::size_t run = 0;
      for (; k >= lengths[run]; ++run) k -= lengths[run];
      return {begins[run] + k, lengths[run] - k};
    }
  };

  std::span<TriangleGroup> groups_;
  WorkerPool& pool_;
};

/// Where no plane parts the centres, any half is as good as another.
std::pair<GroupRange, GroupRange> halves(std::span<const TriangleGroup> groups, const GroupRange& range) {
  const std::uint32_t middle = range.begin + range.count() / 2;
  GroupRange left{range.begin, middle}, right{middle, range.end};
  for (GroupRange* half : {&left, &right})
    for (std::uint32_t i = half->begin; i < half->end; ++i) half->add(groups[i]);
  return {left, right};
}

}  // namespace

std::pair<GroupRange, GroupRange> split_groups(std::span<TriangleGroup> groups, const GroupRange& range, bool by_number,
                                               WorkerPool& pool) {
  if (by_number || range.count() == 2) return halves(groups, range);
  const std::span<TriangleGroup> part_of = groups.subspan(range.begin, range.count());
  const Binning binning(range.centers, bins_for(range.count()));
  const bool is_long = range.count() >= kSliced;
  BinnedSplit split;
  if (is_long) {
    split = SlicedRange(part_of, pool).best_split(binning, range.triangles);
  } else {
    BoxBins bins(bins_for(range.count()));
    bins.add(part_of, binning);
    split = bins.best_split(range.triangles);
  }
  if (!split.exists()) return halves(groups, range);
  const Sides sides = is_long ? SlicedRange(part_of, pool).part(binning, split) : part(part_of, binning, split);
  const std::uint32_t middle = range.begin + sides.below;
  return {GroupRange{range.begin, middle, split.left_triangles, split.left, sides.left_centers},
          GroupRange{middle, range.end, range.triangles - split.left_triangles, split.right, sides.right_centers}};
}

}  // namespace plumb
