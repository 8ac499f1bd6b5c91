#pragma once

#include <array>
#include <cstdint>

#include "renderer/image/picture.h"

namespace plumb {

/// How far one channel of a picture lies from the reference, in 8-bit levels, or linear for EXR.
struct ChannelDifference {
  double max = 0;
  double mean = 0;  ///< of the absolute differences
  double rms = 0;
  /// The share of the samples that differ by more than the tolerance.
  double share_past = 0;
};

struct PictureDifference {
  std::array<ChannelDifference, 3> channels;
  std::int64_t pixels = 0;
  /// Pixels with a channel that differs by more than the tolerance.
  std::int64_t pixels_past = 0;
  /// The largest difference of any channel, and the first pixel, row by row from the top, that has it.
  double max = 0;
  int max_x = 0, max_y = 0;
};

/// Both pictures must be of the same size and kind, with finite samples (compare/judge_picture.h checks).
PictureDifference difference(const Picture& reference, const Picture& picture, double tolerance);

/// The largest channel difference of one pixel.
double pixel_difference(const Picture& reference, const Picture& picture, int x, int y);

}  // namespace plumb
