#pragma once

#include <vector>

#include "renderer/image/picture.h"

namespace plumb {

/// The paper's usual view: a screen of 3840 pixels on 0.7 m, seen from 0.7 m: 3840 * pi / 180.
constexpr double kFlipPixelsPerDegree = 67.02064327658226;

/// How visible the differences of two pictures are to someone who flips between them: 0 not at all, 1 as much as can
/// be.
struct FlipErrors {
  int width = 0;
  int height = 0;
  std::vector<float> error;  ///< a pixel each, rows from the top, from 0 to 1
  double mean = 0;
  double p99 = 0;  ///< the smallest error that at least 99 % of the pixels do not exceed
  double max = 0;
};

/// LDR-FLIP [Andersson et al. 2020] of two pictures of the same size in 8-bit levels (of sRGB, which is what FLIP is
/// defined for), with finite samples. Without pixels all figures are 0. The same bits on every machine, but for the
/// weights of the filters and the sRGB curve, which come from exp and pow.
///
/// Throws std::invalid_argument if the sizes differ, a picture is linear, or pixels_per_degree is not from 1 to 1000.
FlipErrors flip(const Picture& reference, const Picture& picture, double pixels_per_degree = kFlipPixelsPerDegree);

}  // namespace plumb
