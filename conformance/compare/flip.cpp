#include "conformance/compare/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <stdexcept>

#include "conformance/compare/flip_color.h"
#include "conformance/compare/flip_filters.h"

namespace plumb {
namespace {

// The paper's constants, by its names.
constexpr float kQc = 0.7F;   // the exponent that compresses large differences of colour
constexpr float kPc = 0.4F;   // the share of the largest difference ...
constexpr float kPt = 0.95F;  // ... that is mapped to this error; what lies above it shares the rest

/// The distance for large differences of colour: city block in lightness, Euclidean in chroma.
Lanes hyab(const HuntLab& p, const HuntLab& q) {
  const Lanes a = p.a - q.a, b = p.b - q.b;
  return magnitude_of(p.lightness - q.lightness) + root_of(a * a + b * b);
}

/// What the eye sees of a filtered opponent colour: filtering may have led out of what a screen can show.
HuntLab seen(Lanes achromatic, Lanes red_green, Lanes blue_yellow) {
  auto rgb = times(kRgbFromRelativeXyz, achromatic + red_green, achromatic, achromatic - blue_yellow);
  for (Lanes& c : rgb) c = lower_of(higher_of(c, all_lanes(0)), all_lanes(1));
  return hunt_lab(times(kRelativeXyzFromRgb, rgb[0], rgb[1], rgb[2]));
}

/// The largest compressed difference: between the green and the blue of the screen.
float largest_color_difference() {
  static const float largest = [] {
    const Lanes none = all_lanes(0), full = all_lanes(1);
    const HuntLab green = hunt_lab(times(kRelativeXyzFromRgb, none, full, none));
    const HuntLab blue = hunt_lab(times(kRelativeXyzFromRgb, none, none, full));
    return power_of(hyab(green, blue), all_lanes(kQc))[0];
  }();
  return largest;
}

Lanes color_error(Lanes distance) {
  const float largest = largest_color_difference(), knee = kPc * largest;
  const Lanes compressed = power_of(distance, all_lanes(kQc));
  const Lanes low = compressed * (kPt / knee);
  const Lanes high = kPt + (compressed - knee) * ((1 - kPt) / (largest - knee));
  return lower_of(compressed < knee ? low : high, all_lanes(1));
}

/// Of the pixels from i on of two tiles: the colours' error, raised by a difference of edges or points.
Lanes errors_of(const FlipTile& p, const FlipTile& q, std::size_t i) {
  const auto at = [i](const FlipPlane& plane) { return load_lanes(plane.data() + i); };
  const Lanes distance = hyab(seen(at(p.achromatic), at(p.red_green), at(p.blue_yellow)),
                              seen(at(q.achromatic), at(q.red_green), at(q.blue_yellow)));
  const Lanes edges = magnitude_of(at(p.edge) - at(q.edge)), points = magnitude_of(at(p.point) - at(q.point));
  const Lanes features = root_of(0.70710678F * higher_of(edges, points));
  return power_of(color_error(distance), 1.0F - features);
}

/// Whether all pixels on which a tile depends are equal. Then its errors are exactly 0.
bool tile_is_equal(const Picture& p, const Picture& q, int x0, int y0, int radius) {
  const int left = std::max(x0 - radius, 0), right = std::min(x0 + kFlipTile + radius, p.width);
  const int top = std::max(y0 - radius, 0), bottom = std::min(y0 + kFlipTile + radius, p.height);
  const std::size_t bytes = sizeof(float) * 3 * static_cast<std::size_t>(right - left);
  for (int y = top; y < bottom; ++y)
    if (std::memcmp(p.pixel(left, y), q.pixel(left, y), bytes) != 0) return false;
  return true;
}

void pool(FlipErrors& result) {
  if (result.error.empty()) return;
  double sum = 0;
  std::vector<float> seen_errors;
  for (const float error : result.error) {
    if (error == 0) continue;
    sum += static_cast<double>(error);
    seen_errors.push_back(error);
  }
  const std::size_t count = result.error.size(), zeros = count - seen_errors.size();
  result.mean = sum / static_cast<double>(count);
  if (seen_errors.empty()) return;
  result.max = static_cast<double>(std::ranges::max(seen_errors));
  const std::size_t rank = (99 * count + 99) / 100 - 1;  // of the sorted errors, from 0
  if (rank < zeros) return;
  const auto place = seen_errors.begin() + static_cast<std::ptrdiff_t>(rank - zeros);
  std::ranges::nth_element(seen_errors, place);
  result.p99 = static_cast<double>(*place);
}

}  // namespace

FlipErrors flip(const Picture& reference, const Picture& picture, double pixels_per_degree) {
  if (reference.width != picture.width || reference.height != picture.height)
    throw std::invalid_argument("FLIP needs two pictures of the same size");
  if (reference.is_linear() || picture.is_linear()) throw std::invalid_argument("FLIP needs pictures in 8-bit levels");
  if (!(pixels_per_degree >= 1 && pixels_per_degree <= 1000))
    throw std::invalid_argument("FLIP needs from 1 to 1000 pixels per degree");
  FlipErrors result{reference.width, reference.height, std::vector<float>(reference.samples.size() / 3), 0, 0, 0};
  if (reference.samples == picture.samples) return result;

  const FlipFilters filters(pixels_per_degree);
  FlipTileFilter reference_filter(reference, filters), picture_filter(picture, filters);
  const auto tiles = std::make_unique<std::array<FlipTile, 2>>();
  for (int y0 = 0; y0 < reference.height; y0 += kFlipTile) {
    for (int x0 = 0; x0 < reference.width; x0 += kFlipTile) {
      if (tile_is_equal(reference, picture, x0, y0, filters.radius)) continue;
      reference_filter.filter(x0, y0, (*tiles)[0]);
      picture_filter.filter(x0, y0, (*tiles)[1]);
      const int columns = std::min(kFlipTile, reference.width - x0), rows = std::min(kFlipTile, reference.height - y0);
      std::array<float, kFlipTile> errors;
      for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; x += kLanes)
          store_lanes(errors_of((*tiles)[0], (*tiles)[1], static_cast<std::size_t>(y * kFlipTile + x)),
                      errors.data() + x);
        std::copy_n(errors.begin(), columns,
                    result.error.begin() + static_cast<std::ptrdiff_t>(y0 + y) * reference.width + x0);
      }
    }
  }
  pool(result);
  return result;
}

}  // namespace plumb
