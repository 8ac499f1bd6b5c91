#include "conformance/compare/picture_difference.h"

#include <algorithm>
#include <cmath>

namespace plumb {
namespace {

double channel_difference(const float* a, const float* b, std::size_t channel) {
  return std::fabs(static_cast<double>(a[channel]) - static_cast<double>(b[channel]));
}

}  // namespace

double pixel_difference(const Picture& reference, const Picture& picture, int x, int y) {
  const float* a = reference.pixel(x, y);
  const float* b = picture.pixel(x, y);
  return std::max({channel_difference(a, b, 0), channel_difference(a, b, 1), channel_difference(a, b, 2)});
}

PictureDifference difference(const Picture& reference, const Picture& picture, double tolerance) {
  PictureDifference result;
  result.pixels = static_cast<std::int64_t>(reference.width) * reference.height;
  std::array<std::int64_t, 3> past{};
  for (int y = 0; y < reference.height; ++y) {
    for (int x = 0; x < reference.width; ++x) {
      const float* a = reference.pixel(x, y);
      const float* b = picture.pixel(x, y);
      double largest = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        const double d = channel_difference(a, b, c);
        ChannelDifference& channel = result.channels[c];
        channel.max = std::max(channel.max, d);
        channel.mean += d;
        channel.rms += d * d;
        if (d > tolerance) ++past[c];
        largest = std::max(largest, d);
      }
      if (largest > tolerance) ++result.pixels_past;
      if (largest > result.max) {
        result.max = largest;
        result.max_x = x;
        result.max_y = y;
      }
    }
  }
  const double count = static_cast<double>(result.pixels);
  for (std::size_t c = 0; c < 3; ++c) {
    result.channels[c].mean /= count;
    result.channels[c].rms = std::sqrt(result.channels[c].rms / count);
    result.channels[c].share_past = static_cast<double>(past[c]) / count;
  }
  return result;
}

}  // namespace plumb
