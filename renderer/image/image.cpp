#include "renderer/image/image.h"

#include <cmath>

namespace plumb {

Image::Image(int width, int height)
    : width_(width), height_(height), pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

std::uint8_t level_of(double linear) {
  if (!(linear > 0)) return 0;
  const double encoded = std::pow(linear, 1 / 2.2);
  const double clamped = static_cast<float>(encoded < 1 ? encoded : 1);
  return static_cast<std::uint8_t>(std::floor(255 * clamped + 0.5));
}

std::vector<std::uint8_t> levels_of(const Image& image) {
  std::vector<std::uint8_t> levels;
  levels.reserve(image.pixels().size() * 3);
  for (const Color& c : image.pixels()) {
    levels.push_back(level_of(c.r));
    levels.push_back(level_of(c.g));
    levels.push_back(level_of(c.b));
  }
  return levels;
}

}  // namespace plumb
