#pragma once

#include <array>
#include <vector>

#include "renderer/image/picture.h"

namespace plumb {

/// One dimension of a filter that is symmetric, or antisymmetric: `taps[0]` weighs the middle, `taps[k]` the samples k
/// to both sides (an antisymmetric one takes the sample before with the sign changed).
struct FlipKernel {
  std::vector<float> taps;
  bool antisymmetric = false;

  int radius() const { return static_cast<int>(taps.size()) - 1; }
};

/// The filters of FLIP, each a product of one along x and one along y, or the sum of two such [Andersson et al. 2020].
/// `achromatic`, `red_green` and the sum of `blue_yellow` are the contrast sensitivity of the eye for the three
/// opponent channels; each weighs a constant picture by 1. `smooth`, `edge` and `point` are a Gaussian and its first
/// and second derivative, whose positive weights add up to 1 and whose negative ones to -1.
struct FlipFilters {
  explicit FlipFilters(double pixels_per_degree);

  FlipKernel achromatic, red_green;
  std::array<FlipKernel, 2> blue_yellow;
  FlipKernel smooth, edge, point;
  /// How far the widest of them reaches.
  int radius = 0;
};

constexpr int kFlipTile = 64;
using FlipPlane = std::array<float, kFlipTile * kFlipTile>;

/// A square of a picture as the eye sees it: after the filters, in linear opponent channels scaled so that white is
/// (1, 0, 0), and how strong its edges and points are.
struct FlipTile {
  FlipPlane achromatic, red_green, blue_yellow;
  FlipPlane edge, point;
};

/// Cuts tiles out of a picture in 8-bit levels and filters them. Beyond the picture its border pixels go on.
class FlipTileFilter {
 public:
  /// Both must outlive this.
  FlipTileFilter(const Picture& picture, const FlipFilters& filters);
  /// The tile whose top left pixel is (x0, y0), as far as it lies in the picture. A pixel depends on those within the
  /// filters' radius alone, and its bits not on where the tile starts.
  void filter(int x0, int y0, FlipTile& tile);

 private:
  void load_opponents(int x0, int y0, int columns, int rows);

  const Picture& picture_;
  const FlipFilters& filters_;
  int side_;  ///< of a tile with what the filters reach beyond it, a multiple of kLanes
  std::array<std::vector<float>, 3> opponents_;
  /// Filtered along x: achromatic, red_green, blue_yellow twice, smooth, edge, point.
  std::array<std::vector<float>, 7> lines_;
};

}  // namespace plumb
