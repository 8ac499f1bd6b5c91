#pragma once

#include <cstdint>
#include <vector>

#include "renderer/image/picture.h"

namespace plumb {

/// Which pixels of a picture are wrong: a byte each, rows from the top, not 0 where wrong.
struct PixelMask {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> wrong;

  bool at(int x, int y) const {
    return wrong[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)] != 0;
  }
};

/// A rectangle of pixels, (x, y) its top left one, and how many wrong ones are meant by it.
struct WrongRegion {
  int x = 0, y = 0, width = 0, height = 0;
  std::int64_t wrong = 0;
};

struct WrongRegions {
  std::int64_t wrong = 0;  ///< pixels in all
  std::int64_t blobs = 0;  ///< sets of wrong pixels that touch, at corners too
  /// The box around the largest blob and the blob's pixels; of several of one size the first by its top row, then by
  /// that row's leftmost pixel. Empty where nothing is wrong.
  WrongRegion largest_blob;
  /// The window with most wrong pixels, the first by rows of several. Empty where nothing is wrong.
  WrongRegion densest_window;
};

/// The pixels with a channel that differs from the reference's by more than `tolerance`; both pictures must have the
/// same size and kind, and finite samples.
PixelMask wrong_pixels(const Picture& reference, const Picture& picture, double tolerance);

/// `window` is the side of the window, at least 1; it is cut to the picture's sides where these are shorter. Takes time
/// proportional to the pixels.
WrongRegions wrong_regions(const PixelMask& mask, int window = 16);

/// How many pixels of any rectangle are wrong, in constant time: a summed-area table [Crow 1984].
class WrongCounts {
 public:
  explicit WrongCounts(const PixelMask& mask);
  /// In columns from x0 up to but without x1, rows likewise. An empty rectangle has none.
  std::int64_t in(int x0, int y0, int x1, int y1) const;

 private:
  std::int64_t above_left(int x, int y) const {
    return sums_[static_cast<std::size_t>(y) * stride_ + static_cast<std::size_t>(x)];
  }
  std::size_t stride_;
  std::vector<std::int64_t> sums_;
};

}  // namespace plumb
