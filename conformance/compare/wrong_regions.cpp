#include "conformance/compare/wrong_regions.h"

#include <algorithm>
#include <cmath>

namespace plumb {
namespace {

struct Pixel {
  int x, y;
};

/// Takes blobs out of a copy of the mask, one after another, with a stack of their pixels.
class BlobFinder {
 public:
  explicit BlobFinder(const PixelMask& mask) : left_(mask) {}

  bool is_left(int x, int y) const { return left_.at(x, y); }

  WrongRegion take(int x, int y) {
    int left = x, right = x, top = y, bottom = y;
    std::int64_t count = 0;
    visit(x, y);
    while (!stack_.empty()) {
      const Pixel p = stack_.back();
      stack_.pop_back();
      ++count;
      left = std::min(left, p.x);
      right = std::max(right, p.x);
      top = std::min(top, p.y);
      bottom = std::max(bottom, p.y);
      for (int ny = std::max(p.y - 1, 0); ny <= std::min(p.y + 1, left_.height - 1); ++ny)
        for (int nx = std::max(p.x - 1, 0); nx <= std::min(p.x + 1, left_.width - 1); ++nx)
          if (left_.at(nx, ny)) visit(nx, ny);
    }
    return {left, top, right - left + 1, bottom - top + 1, count};
  }

 private:
  void visit(int x, int y) {
    left_.wrong[static_cast<std::size_t>(y) * static_cast<std::size_t>(left_.width) + static_cast<std::size_t>(x)] = 0;
    stack_.push_back({x, y});
  }

  PixelMask left_;
  std::vector<Pixel> stack_;
};

WrongRegion densest(const PixelMask& mask, int window) {
  const WrongCounts counts(mask);
  WrongRegion best;
  const int width = std::min(window, mask.width), height = std::min(window, mask.height);
  for (int y = 0; y + height <= mask.height; ++y) {
    for (int x = 0; x + width <= mask.width; ++x) {
      const std::int64_t wrong = counts.in(x, y, x + width, y + height);
      if (wrong > best.wrong) best = {x, y, width, height, wrong};
    }
  }
  return best;
}

}  // namespace

PixelMask wrong_pixels(const Picture& reference, const Picture& picture, double tolerance) {
  PixelMask mask{reference.width, reference.height, std::vector<std::uint8_t>(reference.samples.size() / 3)};
  const float* a = reference.samples.data();
  const float* b = picture.samples.data();
  const auto differs = [&](std::size_t i) {
    return std::fabs(static_cast<double>(a[i]) - static_cast<double>(b[i])) > tolerance;
  };
  for (std::size_t i = 0; i < mask.wrong.size(); ++i)
    mask.wrong[i] = differs(3 * i) || differs(3 * i + 1) || differs(3 * i + 2);
  return mask;
}

WrongRegions wrong_regions(const PixelMask& mask, int window) {
  WrongRegions regions;
  BlobFinder finder(mask);
  for (int y = 0; y < mask.height; ++y) {
    for (int x = 0; x < mask.width; ++x) {
      if (!finder.is_left(x, y)) continue;
      const WrongRegion blob = finder.take(x, y);
      ++regions.blobs;
      regions.wrong += blob.wrong;
      if (blob.wrong > regions.largest_blob.wrong) regions.largest_blob = blob;
    }
  }
  if (regions.wrong > 0) regions.densest_window = densest(mask, window);
  return regions;
}

WrongCounts::WrongCounts(const PixelMask& mask)
    : stride_(static_cast<std::size_t>(mask.width) + 1), sums_(stride_ * (static_cast<std::size_t>(mask.height) + 1)) {
  for (int y = 0; y < mask.height; ++y) {
    std::int64_t row = 0;
    for (int x = 0; x < mask.width; ++x) {
      row += mask.at(x, y) ? 1 : 0;
      sums_[static_cast<std::size_t>(y + 1) * stride_ + static_cast<std::size_t>(x + 1)] = above_left(x + 1, y) + row;
    }
  }
}

std::int64_t WrongCounts::in(int x0, int y0, int x1, int y1) const {
  if (x0 >= x1 || y0 >= y1) return 0;
  return above_left(x1, y1) - above_left(x0, y1) - above_left(x1, y0) + above_left(x0, y0);
}

}  // namespace plumb
