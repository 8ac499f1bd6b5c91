#include "conformance/compare/heat_map.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "conformance/compare/picture_difference.h"

namespace plumb {
namespace {

using Level3 = std::array<std::uint8_t, 3>;

using Anchors = std::array<std::array<double, 3>, 5>;

/// From violet to white.
constexpr Anchors kHeat{{{110, 30, 160}, {200, 30, 90}, {240, 90, 30}, {255, 190, 40}, {255, 255, 255}}};
/// From black to pale yellow.
constexpr Anchors kVisibility{{{0, 0, 0}, {75, 20, 110}, {175, 45, 115}, {245, 120, 85}, {255, 250, 190}}};

/// Piecewise linear between anchors; `share` from 0 to 1.
Level3 color_on(const Anchors& anchors, double share) {
  const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(anchors.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(place), anchors.size() - 2);
  const double part = place - static_cast<double>(below);
  Level3 color;
  for (std::size_t c = 0; c < 3; ++c)
    color[c] = static_cast<std::uint8_t>(std::lround((1 - part) * anchors[below][c] + part * anchors[below + 1][c]));
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
      const Level3 color = d > 0 ? color_on(kHeat, std::log2(std::max(d, 1.0)) / std::log2(255.0))
                                 : backdrop(reference.pixel(x, y), to_levels);
      levels.insert(levels.end(), color.begin(), color.end());
    }
  }
  return levels;
}

std::vector<std::uint8_t> flip_map(const FlipErrors& errors) {
  std::vector<std::uint8_t> levels;
  levels.reserve(3 * errors.error.size());
  for (const float error : errors.error) {
    const Level3 color = color_on(kVisibility, static_cast<double>(error));
    levels.insert(levels.end(), color.begin(), color.end());
  }
  return levels;
}

}  // namespace plumb
