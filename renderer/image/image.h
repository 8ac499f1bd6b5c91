#pragma once

#include <cstdint>
#include <vector>

#include "renderer/math/vec3.h"

namespace plumb {

/// A rendered picture: linear colours, row 0 at the top.
class Image {
 public:
  /// Black. Width and height must not be negative.
  Image(int width, int height);
  int width() const { return width_; }
  int height() const { return height_; }
  Color& at(int x, int y) { return pixels_[index(x, y)]; }
  const Color& at(int x, int y) const { return pixels_[index(x, y)]; }
  const std::vector<Color>& pixels() const { return pixels_; }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  int width_;
  int height_;
  std::vector<Color> pixels_;
};

/// The 8-bit level of a linear value, as the course writes it: c^(1/2.2), clamped to [0,1], rounded to
/// float, then floor(255 c + 0.5). NaN and negative values give 0.
std::uint8_t level_of(double linear);

/// The levels of a whole image, three bytes a pixel, rows from the top.
std::vector<std::uint8_t> levels_of(const Image& image);

}  // namespace plumb
