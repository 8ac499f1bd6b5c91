#include "conformance/compare/flip_filters.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "conformance/compare/flip_color.h"

namespace plumb {
namespace {

/// exp(-factor k^2) for k from 0 to the radius. Weights below 2^-30 of the first are left out: all of them together are
/// less than half of the last place of the sum.
std::vector<double> bell(double factor, int radius) {
  std::vector<double> weights;
  for (int k = 0; k <= radius; ++k) {
    const double weight = std::exp(-factor * k * k);
    if (weight < 0x1p-30) break;
    weights.push_back(weight);
  }
  return weights;
}

double sum_of_both_sides(const std::vector<double>& weights) {
  double sum = weights[0];
  for (std::size_t k = 1; k < weights.size(); ++k) sum += 2 * weights[k];
  return sum;
}

FlipKernel scaled(const std::vector<double>& weights, double scale) {
  FlipKernel kernel;
  for (const double weight : weights) kernel.taps.push_back(static_cast<float>(scale * weight));
  return kernel;
}

/// a sqrt(pi / b) exp(-pi^2 d^2 / b), d in degrees: the transform of a exp(-b f^2), the eye's sensitivity to f cycles a
/// degree. The table is the paper's, section 4.1.1.
struct Sensitivity {
  double a, b;

  double height() const { return a * std::sqrt(std::numbers::pi / b); }
  std::vector<double> weights(double pixels_per_degree, int radius) const {
    const double pi_by_pixels = std::numbers::pi / pixels_per_degree;
    return bell(pi_by_pixels * pi_by_pixels / b, radius);
  }
};
constexpr Sensitivity kAchromatic{1, 0.0047}, kRedGreen{1, 0.0053}, kBlueYellow1{34.1, 0.04}, kBlueYellow2{13.5, 0.025};

/// Of the edges and points that the eye looks for, in degrees.
constexpr double kFeatureWidth = 0.082;

/// Scales positive and negative weights separately, so that each add up to 1.
FlipKernel balanced(const std::vector<double>& weights, bool antisymmetric) {
  double positive = std::max(weights[0], 0.0), negative = std::max(-weights[0], 0.0);
  for (std::size_t k = 1; k < weights.size(); ++k) {
    const double weight = weights[k];
    positive += antisymmetric ? std::fabs(weight) : 2 * std::max(weight, 0.0);
    negative += antisymmetric ? std::fabs(weight) : 2 * std::max(-weight, 0.0);
  }
  FlipKernel kernel;
  kernel.antisymmetric = antisymmetric;
  for (const double weight : weights)
    kernel.taps.push_back(static_cast<float>(weight > 0 ? weight / positive : weight < 0 ? weight / negative : 0));
  return kernel;
}

/// The linear value of an sRGB level [IEC 61966-2-1].
float linear_of(float level) {
  const double c = std::clamp(static_cast<double>(level) / 255, 0.0, 1.0);
  return static_cast<float>(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
}

/// The linear values of sRGB levels. Whole ones are looked up: all but those of pictures of 16 bits.
class LinearLevels {
 public:
  LinearLevels() {
    for (std::size_t i = 0; i < of_whole_.size(); ++i) of_whole_[i] = linear_of(static_cast<float>(i));
  }
  float operator()(float level) const {
    const auto whole = static_cast<std::int32_t>(level);
    if (static_cast<float>(whole) != level || whole < 0 || whole > 255) return linear_of(level);
    return of_whole_[static_cast<std::size_t>(whole)];
  }

 private:
  std::array<float, 256> of_whole_{};
};

/// As many samples as are filtered at a time: their sums fit into registers.
constexpr int kBlock = 4 * kLanes;
constexpr int whole_blocks(int count) { return (count + kBlock - 1) / kBlock * kBlock; }

/// `count` filtered samples, rounded up to whole blocks. `step` leads from a sample to the next along the filter.
template <bool antisymmetric>
void filter_line(const float* in, std::ptrdiff_t step, const FlipKernel& kernel, int count, float* out) {
  for (int start = 0; start < count; start += kBlock) {
    std::array<Lanes, kBlock / kLanes> sums;
    const float* const middle = in + start;
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] = kernel.taps[0] * load_lanes(middle + i * kLanes);
    for (int k = 1; k <= kernel.radius(); ++k) {
      const float weight = kernel.taps[static_cast<std::size_t>(k)];
      for (std::size_t i = 0; i < sums.size(); ++i) {
        const Lanes before = load_lanes(middle - k * step + i * kLanes);
        const Lanes after = load_lanes(middle + k * step + i * kLanes);
        sums[i] += weight * (antisymmetric ? after - before : after + before);
      }
    }
    for (std::size_t i = 0; i < sums.size(); ++i) store_lanes(sums[i], out + start + i * kLanes);
  }
}

void filter_line(const float* in, std::ptrdiff_t step, const FlipKernel& kernel, int count, float* out) {
  kernel.antisymmetric ? filter_line<true>(in, step, kernel, count, out)
                       : filter_line<false>(in, step, kernel, count, out);
}

Lanes length_of(Lanes x, Lanes y) { return root_of(x * x + y * y); }

}  // namespace

FlipFilters::FlipFilters(double pixels_per_degree) {
  // Three standard deviations of the widest sensitivity, whose b is the largest.
  const double sigma = std::sqrt(kBlueYellow1.b / 2) / std::numbers::pi;
  const int color_radius = static_cast<int>(std::ceil(3 * sigma * pixels_per_degree));
  const auto alone = [&](const Sensitivity& sensitivity) {
    const auto weights = sensitivity.weights(pixels_per_degree, color_radius);
    return scaled(weights, 1 / sum_of_both_sides(weights));
  };
  achromatic = alone(kAchromatic);
  red_green = alone(kRedGreen);
  const auto first = kBlueYellow1.weights(pixels_per_degree, color_radius);
  const auto second = kBlueYellow2.weights(pixels_per_degree, color_radius);
  const double first_sum = sum_of_both_sides(first), second_sum = sum_of_both_sides(second);
  const double volume = kBlueYellow1.height() * first_sum * first_sum + kBlueYellow2.height() * second_sum * second_sum;
  blue_yellow = {scaled(first, std::sqrt(kBlueYellow1.height() / volume)),
                 scaled(second, std::sqrt(kBlueYellow2.height() / volume))};

  const double feature_sigma = 0.5 * kFeatureWidth * pixels_per_degree;
  const double variance = feature_sigma * feature_sigma;
  const int feature_radius = static_cast<int>(std::ceil(3 * feature_sigma));
  std::vector<double> gaussian = bell(0.5 / variance, feature_radius), first_derivative, second_derivative;
  for (std::size_t k = 0; k < gaussian.size(); ++k) {
    const auto x = static_cast<double>(k);
    first_derivative.push_back(-x * gaussian[k]);
    second_derivative.push_back((x * x / variance - 1) * gaussian[k]);
  }
  smooth = scaled(gaussian, 1 / sum_of_both_sides(gaussian));
  edge = balanced(first_derivative, true);
  point = balanced(second_derivative, false);
  radius = std::max(color_radius, feature_radius);
}

FlipTileFilter::FlipTileFilter(const Picture& picture, const FlipFilters& filters)
    : picture_(picture), filters_(filters), side_((kFlipTile + 2 * filters.radius + kLanes - 1) / kLanes * kLanes) {
  const auto side = static_cast<std::size_t>(side_);
  for (auto& plane : opponents_) plane.resize(side * side);
  for (auto& plane : lines_) plane.resize(side * kFlipTile);
}

void FlipTileFilter::load_opponents(int x0, int y0, int columns, int rows) {
  std::vector<float> red(static_cast<std::size_t>(side_)), green(red), blue(red);
  static const LinearLevels linear;
  std::vector<std::ptrdiff_t> places;  // of the samples in a line of the picture
  for (int column = 0; column < columns + 2 * filters_.radius; ++column)
    places.push_back(3 * std::clamp(x0 + column - filters_.radius, 0, picture_.width - 1));
  for (int row = 0; row < rows + 2 * filters_.radius; ++row) {
    const float* const line = picture_.pixel(0, std::clamp(y0 + row - filters_.radius, 0, picture_.height - 1));
    for (std::size_t i = 0; i < places.size(); ++i) {
      const float* const p = line + places[i];
      red[i] = linear(p[0]);
      green[i] = linear(p[1]);
      blue[i] = linear(p[2]);
    }
    // Y, and the differences to it that FLIP's YCxCz is made of. Its factors and its offset fall out: filters are
    // linear and keep constants.
    const auto first = static_cast<std::size_t>(row * side_);
    for (std::size_t i = 0; i < red.size(); i += kLanes) {
      const auto xyz = times(kRelativeXyzFromRgb, load_lanes(&red[i]), load_lanes(&green[i]), load_lanes(&blue[i]));
      store_lanes(xyz[1], &opponents_[0][first + i]);
      store_lanes(xyz[0] - xyz[1], &opponents_[1][first + i]);
      store_lanes(xyz[1] - xyz[2], &opponents_[2][first + i]);
    }
  }
}

void FlipTileFilter::filter(int x0, int y0, FlipTile& tile) {
  const int columns = whole_blocks(std::min(kFlipTile, picture_.width - x0));
  const int rows = std::min(kFlipTile, picture_.height - y0);
  load_opponents(x0, y0, columns, rows);
  const FlipFilters& f = filters_;
  const struct {
    std::size_t opponent;
    const FlipKernel& kernel;
  } along_x[] = {{0, f.achromatic}, {1, f.red_green}, {2, f.blue_yellow[0]}, {2, f.blue_yellow[1]},
                 {0, f.smooth},     {0, f.edge},      {0, f.point}};
  for (std::size_t k = 0; k < lines_.size(); ++k) {
    const float* const in = opponents_[along_x[k].opponent].data() + f.radius;
    for (int row = 0; row < rows + 2 * f.radius; ++row)
      filter_line(in + row * side_, 1, along_x[k].kernel, columns, lines_[k].data() + row * kFlipTile);
  }
  for (int y = 0; y < rows; ++y) {
    const auto along_y = [&](std::size_t k, const FlipKernel& kernel, float* out) {
      filter_line(lines_[k].data() + (y + f.radius) * kFlipTile, kFlipTile, kernel, columns, out);
    };
    const std::ptrdiff_t line = y * kFlipTile;
    std::array<float, kFlipTile> second, edge_x, edge_y, point_x, point_y;
    float* const blue_yellow = tile.blue_yellow.data() + line;
    along_y(0, f.achromatic, tile.achromatic.data() + line);
    along_y(1, f.red_green, tile.red_green.data() + line);
    along_y(2, f.blue_yellow[0], blue_yellow);
    along_y(3, f.blue_yellow[1], second.data());
    along_y(5, f.smooth, edge_x.data());
    along_y(4, f.edge, edge_y.data());
    along_y(6, f.smooth, point_x.data());
    along_y(4, f.point, point_y.data());
    for (int x = 0; x < columns; x += kLanes) {
      const auto at = [x](const std::array<float, kFlipTile>& samples) { return load_lanes(samples.data() + x); };
      store_lanes(load_lanes(blue_yellow + x) + at(second), blue_yellow + x);
      store_lanes(length_of(at(edge_x), at(edge_y)), tile.edge.data() + line + x);
      store_lanes(length_of(at(point_x), at(point_y)), tile.point.data() + line + x);
    }
  }
}

}  // namespace plumb
