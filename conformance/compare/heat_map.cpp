#include "conformance/compare/heat_map.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "conformance/compare/picture_difference.h"

namespace plumb {
namespace {

using Level3 = std::array<std::uint8_t, 3>;

/// Piecewise linear between anchors; `heat` from 0 to 1.
Level3 heat_color(double heat) {
  static constexpr std::array<std::array<double, 3>, 5> kAnchors{
      {{110, 30, 160}, {200, 30, 90}, {240, 90, 30}, {255, 190, 40}, {255, 255, 255}}};
  const double place = std::clamp(heat, 0.0, 1.0) * (kAnchors.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(place), kAnchors.size() - 2);
  const double share = place - static_cast<double>(below);
  Level3 color;
  for (std::size_t c = 0; c < 3; ++c) {
    color[c] =
        static_cast<std::uint8_t>(std::lround((1 - share) * kAnchors[below][c] + share * kAnchors[below + 1][c]));
  }
  return color;
}

Level3 backdrop(const float* p, double to_levels) {
  const double grey = (0.3 * p[0] + 0.6 * p[1] + 0.1 * p[2]) * to_levels;
  const auto level = static_cast<std::uint8_t>(std::clamp(grey, 0.0, 255.0) / 5);
  return {level, level, level};
}

}  // namespace

std::vector<std::uint8_t> heat_map(const Picture& reference, const Picture& picture) {
  const double to_levels = reference.is_linear() ? 255 : 1;
  std::vector<std::uint8_t> levels;
  levels.reserve(reference.samples.size());
  for (int y = 0; y < reference.height; ++y) {
    for (int x = 0; x < reference.width; ++x) {
      const double d = pixel_difference(reference, picture, x, y) * to_levels;
      const Level3 color = d > 0 ? heat_color(std::log2(std::max(d, 1.0)) / std::log2(255.0))
                                 : backdrop(reference.pixel(x, y), to_levels);
      levels.insert(levels.end(), color.begin(), color.end());
    }
  }
  return levels;
}

}  // namespace plumb
