#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "renderer/accel/float4.h"
#include "renderer/accel/triangle_group.h"

namespace plumb {

/// Four whole numbers beside a BoxSide.
using BoxCounts = std::int32_t __attribute__((vector_size(16)));

/// Into how many bins so many groups go on each axis.
constexpr int kMostBins = 16, kFewBins = 8;
constexpr std::uint32_t kFewGroups = 16;
constexpr int bins_for(std::uint32_t groups) { return groups > kFewGroups ? kMostBins : kFewBins; }

/// Which bin a group falls into, on each axis, by its centre.
class Binning {
 public:
  /// `centers` holds what center_of says of the groups.
  Binning(const FloatBox& centers, int bins) : low_(centers.low) {
    const BoxSide extent = centers.high - centers.low;
    for (int axis = 0; axis < 3; ++axis) {
      const float scale = 0.9999F * static_cast<float>(bins) / extent[axis];
      scale_[axis] = extent[axis] > 0 && scale < FloatBox::kFar ? scale : 0;
    }
  }
  BoxCounts of(const FloatBox& box) const {
    return __builtin_convertvector((center_of(box) - low_) * scale_, BoxCounts);
  }
  /// On each axis all ones where the centre's bin is below this one, else zero.
  BoxCounts below(BoxSide center, int bin) const {
    return (center - low_) * scale_ < BoxSide{} + static_cast<float>(bin);
  }

 private:
  BoxSide low_;
  BoxSide scale_{};
};

/// A plane between bins.
struct BinnedSplit {
  float cost = std::numeric_limits<float>::infinity();  ///< infinite: there is none
  int axis = 0;
  int bin = 0;  ///< the first on the right
  std::uint32_t left_triangles = 0;
  FloatBox left{}, right{};  ///< around the groups of each side
  bool exists() const { return cost < std::numeric_limits<float>::infinity(); }
};

/// The boxes of groups by bin and axis, and how many triangles are in each.
class BoxBins {
 public:
  explicit BoxBins(int bins) : bins_(static_cast<std::size_t>(bins)) {
    std::fill_n(boxes_.begin(), bins_, Boxes{});
    std::fill_n(counts_.begin(), bins_, BoxCounts{});
  }
  void add(std::span<const TriangleGroup> groups, const Binning& binning);
  void append(const BoxBins& others);
  /// The plane of the least cost by the surface area heuristic that parts these `triangles`; of equal ones the first on
  /// the first axis.
  BinnedSplit best_split(std::uint32_t triangles) const;

 private:
  /// By axis.
  struct Boxes {
    FloatBox x, y, z;
    [[gnu::always_inline]] void extend(const Boxes& others) {
      x.extend(others.x);
      y.extend(others.y);
      z.extend(others.z);
    }
    /// As FloatBox::half_area.
    [[gnu::always_inline]] BoxSide half_areas() const {
      const BoxSide a = x.high - x.low, b = y.high - y.low, c = z.high - z.low;
      const BoxSide ab = __builtin_shufflevector(a, b, 0, 4, 1, 5), cc = __builtin_shufflevector(c, c, 0, 0, 1, 1);
      const BoxSide u = __builtin_shufflevector(ab, cc, 0, 1, 4, 5), v = __builtin_shufflevector(ab, cc, 2, 3, 6, 7);
      const BoxSide w = __builtin_shufflevector(__builtin_shufflevector(a, b, 2, 6, 2, 6), c, 0, 1, 6, 6);
      return u * v + v * w + w * u;
    }
    const FloatBox& of(int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  };
  void add_one(const TriangleGroup& group, const Binning& binning);

  std::size_t bins_;
  std::array<Boxes, kMostBins> boxes_;
  std::array<BoxCounts, kMostBins> counts_;
};

}  // namespace plumb
