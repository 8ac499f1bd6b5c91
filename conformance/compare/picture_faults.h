#pragma once

#include <string>
#include <vector>

#include "renderer/image/picture.h"

namespace plumb {

/// Simple mistakes that concern a whole picture.
enum class PictureFault {
  shift,             ///< by up to 3 whole pixels along x, y or both
  half_pixel_shift,  ///< along x, y or both
  flip_left_right,
  flip_top_bottom,
  rotation_180,
  transposition,
  missing_gamma,  ///< linear values written as they are
  double_gamma,
  swapped_channels,
  black_border,  ///< rows or columns at the border that were never written
  enlarged       ///< a smaller picture, each pixel repeated in a block of 2 x 2, 3 x 3 or 4 x 4
};

/// `flip-left-right` and so on.
std::string to_string(PictureFault fault);

struct FoundFault {
  PictureFault fault = PictureFault::shift;
  /// What is seen, in a plain sentence without a full stop: "the whole picture lies 1 pixel too far to the right".
  std::string sentence;
  /// How much of what is wrong the fault explains; 1 is all. In general wrong pixels that it makes right less right
  /// ones that it makes wrong, as a share of the wrong ones; of half_pixel_shift the share of the sum of squared
  /// differences that it takes away; of enlarged the share of the blocks, among those where the reference has detail.
  double explained = 0;
};

/// The least share that a fault has to explain to be named, but for a half-pixel shift. Of pictures of the course, each
/// spoilt in 27 ways, the one that was there explained at least 0.80, any other at most 0.64 (docs/picture-metrics.md).
constexpr double kLeastExplained = 0.75;

/// The fewest wrong pixels (blocks, of enlarged) that are evidence for anything. If a hypothesis made a wrong pixel
/// right by chance every other time, it would do so for three quarters of 32 with probability 0.0035, and one of the 60
/// hypotheses in less than one picture of four. In truth chance is far less kind, and what a hypothesis makes wrong
/// counts against it.
constexpr int kLeastWrongPixels = 32;

/// The faults that clearly explain a wrong picture, the best first; empty is an answer. Two of them may fit as well,
/// where the reference is symmetric. Both pictures must be in 8-bit levels with finite samples; pixels that differ by
/// no more than `tolerance` levels are right. If the sizes are neither equal nor exchanged, nothing is found; if they
/// are exchanged, a transposition at most.
std::vector<FoundFault> picture_faults(const Picture& reference, const Picture& picture, double tolerance);

}  // namespace plumb
