#include "conformance/compare/flip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <stdexcept>

#include "conformance/compare/flip_filters.h"

namespace plumb {
namespace {

using Triple = std::array<double, 3>;
constexpr double kPi = std::numbers::pi;

/// FLIP as the paper's formulas read: doubles, whole kernels in two dimensions, powers of the C library, no tiles.
class PlainFlip {
 public:
  PlainFlip(const Picture& reference, const Picture& picture, double pixels_per_degree)
      : ppd_(pixels_per_degree), pictures_{&reference, &picture} {}

  double error(int x, int y) const {
    const Triple p = seen(0, x, y), q = seen(1, x, y);
    const double compressed = std::pow(hyab(p, q), 0.7);
    const double largest = std::pow(hyab(hunt({0, 1, 0}), hunt({0, 0, 1})), 0.7), knee = 0.4 * largest;
    const double color =
        compressed < knee ? 0.95 / knee * compressed : 0.95 + (compressed - knee) / (largest - knee) * 0.05;
    const double edges = std::fabs(feature(0, x, y, false) - feature(1, x, y, false));
    const double points = std::fabs(feature(0, x, y, true) - feature(1, x, y, true));
    return std::pow(color, 1 - std::sqrt(std::max(edges, points) / std::sqrt(2)));
  }

 private:
  static Triple xyz(const Triple& rgb) {
    return {(0.4124 * rgb[0] + 0.3576 * rgb[1] + 0.1805 * rgb[2]) / 0.9505,
            0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2],
            (0.0193 * rgb[0] + 0.1192 * rgb[1] + 0.9505 * rgb[2]) / 1.089};
  }
  static Triple rgb_of(const Triple& t) {  // the standard's inverse, of four digits
    const double x = 0.9505 * t[0], y = t[1], z = 1.089 * t[2];
    return {3.2406 * x - 1.5372 * y - 0.4986 * z, -0.9689 * x + 1.8758 * y + 0.0415 * z,
            0.0557 * x - 0.2040 * y + 1.0570 * z};
  }
  static Triple hunt(const Triple& rgb) {
    const auto f = [](double t) {
      const double d = 6.0 / 29;
      return t > d * d * d ? std::cbrt(t) : t / (3 * d * d) + 4.0 / 29;
    };
    const Triple t = xyz(rgb);
    const double l = 116 * f(t[1]) - 16;
    return {l, 0.01 * l * 500 * (f(t[0]) - f(t[1])), 0.01 * l * 200 * (f(t[1]) - f(t[2]))};
  }
  static double hyab(const Triple& p, const Triple& q) {
    return std::fabs(p[0] - q[0]) + std::hypot(p[1] - q[1], p[2] - q[2]);
  }
  /// YCxCz, with the borders going on.
  Triple opponents(int which, int x, int y) const {
    const Picture& picture = *pictures_[static_cast<std::size_t>(which)];
    const float* p = picture.pixel(std::clamp(x, 0, picture.width - 1), std::clamp(y, 0, picture.height - 1));
    Triple rgb;
    for (std::size_t c = 0; c < 3; ++c) {
      const double v = static_cast<double>(p[c]) / 255;
      rgb[c] = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    }
    const Triple t = xyz(rgb);
    return {116 * t[1] - 16, 500 * (t[0] - t[1]), 200 * (t[1] - t[2])};
  }
  Triple seen(int which, int x, int y) const {
    const double a[3][2] = {{1, 0}, {1, 0}, {34.1, 13.5}}, b[3][2] = {{0.0047, 1}, {0.0053, 1}, {0.04, 0.025}};
    const int radius = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * kPi * kPi)) * ppd_));
    Triple sum{}, weights{};
    for (int j = -radius; j <= radius; ++j) {
      for (int i = -radius; i <= radius; ++i) {
        const Triple t = opponents(which, x + i, y + j);
        const double dd = (i * i + j * j) / (ppd_ * ppd_);
        for (std::size_t c = 0; c < 3; ++c) {
          double weight = 0;
          for (int k = 0; k < 2; ++k)
            weight += a[c][k] * std::sqrt(kPi / b[c][k]) * std::exp(-kPi * kPi * dd / b[c][k]);
          sum[c] += weight * t[c];
          weights[c] += weight;
        }
      }
    }
    const double luminance = (sum[0] / weights[0] + 16) / 116;
    Triple rgb = rgb_of({sum[1] / weights[1] / 500 + luminance, luminance, luminance - sum[2] / weights[2] / 200});
    for (double& c : rgb) c = std::clamp(c, 0.0, 1.0);
    return hunt(rgb);
  }
  double feature(int which, int x, int y, bool point) const {
    const double sigma = 0.5 * 0.082 * ppd_;
    const int radius = static_cast<int>(std::ceil(3 * sigma));
    double along[2] = {0, 0};
    for (int axis = 0; axis < 2; ++axis) {
      double positive = 0, negative = 0, positive_weights = 0, negative_weights = 0;
      for (int j = -radius; j <= radius; ++j) {
        for (int i = -radius; i <= radius; ++i) {
          const double u = axis == 0 ? i : j;
          const double weight =
              (point ? u * u / (sigma * sigma) - 1 : -u) * std::exp(-(i * i + j * j) / (2 * sigma * sigma));
          const double value = (opponents(which, x + i, y + j)[0] + 16) / 116;
          (weight > 0 ? positive : negative) += weight * value;
          (weight > 0 ? positive_weights : negative_weights) += std::fabs(weight);
        }
      }
      along[axis] = positive / positive_weights + negative / negative_weights;
    }
    return std::hypot(along[0], along[1]);
  }

  double ppd_;
  std::array<const Picture*, 2> pictures_;
};

Picture paint(int width, int height, const std::function<Triple(int, int)>& levels) {
  Picture picture{PictureFormat::png, width, height, {}, false};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (const double level : levels(x, y)) picture.samples.push_back(static_cast<float>(level));
  return picture;
}

Picture random_picture(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  return paint(width, height, [&](int, int) {
    return Triple{static_cast<double>(random() % 256), static_cast<double>(random() % 256),
                  static_cast<double>(random() % 256)};
  });
}

/// The inverse matrix of the standard has four digits: up to 4e-4 of a linear value, which is at most 4e-4 of the
/// error. Floats and their powers add less than 1e-4.
constexpr double kPlainTolerance = 5e-4;

TEST(Flip, IsWhatThePlainFormulasGive) {
  // 70 x 67 is more than one tile each way. A disk that moved over a coloured ramp, and noise in one corner only, so
  // that some pixels are equal.
  const auto scene = [](double middle, unsigned seed) {
    std::mt19937 random(seed);
    return paint(70, 67, [&, middle](int x, int y) {
      if (std::hypot(x - middle, y - 30) < 9) return Triple{240, 200, 30};
      if (x > 50 && y > 50) return Triple{static_cast<double>(random() % 256), 10, static_cast<double>(random() % 256)};
      return Triple{3.0 * x, 100, 255 - 3.0 * y};
    });
  };
  for (const double pixels_per_degree : {kFlipPixelsPerDegree, 23.0}) {
    const Picture a = scene(40, 1), b = scene(43, 2);
    const FlipErrors errors = flip(a, b, pixels_per_degree);
    const PlainFlip plain(a, b, pixels_per_degree);
    const PlainFlip nearer(a, b, 0.8 * pixels_per_degree);
    int compared = 0, visible = 0, differ = 0;
    for (int y = 0; y < 67; y += 2) {
      for (int x = y % 4 / 2; x < 70; x += 3, ++compared) {
        const double right = plain.error(x, y);
        visible += right > 0.1 ? 1 : 0;
        differ += std::fabs(nearer.error(x, y) - right) > kPlainTolerance ? 1 : 0;
        ASSERT_NEAR(static_cast<double>(errors.error[static_cast<std::size_t>(70 * y + x)]), right, kPlainTolerance)
            << x << "," << y;
      }
    }
    EXPECT_GT(compared, 700);
    EXPECT_GT(visible, 100);
    EXPECT_GT(differ, 100) << "another view is told apart";
  }
}

TEST(Flip, OfRandomPicturesIsWhatThePlainFormulasGive) {
  const Picture a = random_picture(17, 9, 1), b = random_picture(17, 9, 2);
  const FlipErrors errors = flip(a, b);
  const PlainFlip plain(a, b, kFlipPixelsPerDegree);
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 17; ++x)
      ASSERT_NEAR(static_cast<double>(errors.error[static_cast<std::size_t>(17 * y + x)]), plain.error(x, y),
                  kPlainTolerance);
}

TEST(Flip, BlackAndWhiteAreFarApartButGreenAndBlueAreFarthest) {
  const auto constant = [](double r, double g, double b) {
    return paint(5, 5, [=](int, int) { return Triple{r, g, b}; });
  };
  // No edges, so the colours' error alone. 100^0.7 = 25.119; green and blue lie 203.31 apart after Hunt's weights,
  // which is 41.278 after the power, and the knee is 0.4 of that, 16.511: 0.95 + 0.05 (25.119 - 16.511) / (41.278
  // - 16.511).
  const FlipErrors grey = flip(constant(0, 0, 0), constant(255, 255, 255));
  EXPECT_NEAR(grey.mean, 0.967378, 1e-5);
  EXPECT_EQ(grey.mean, grey.max);
  EXPECT_EQ(grey.p99, grey.max);
  EXPECT_NEAR(flip(constant(0, 255, 0), constant(0, 0, 255)).mean, 1, 1e-5);
}

TEST(Flip, EqualPicturesDifferByNothing) {
  const Picture a = random_picture(100, 80, 3);
  const FlipErrors errors = flip(a, a);
  EXPECT_EQ(errors.error.size(), 8000U);
  EXPECT_EQ(errors.mean + errors.p99 + errors.max, 0);
  EXPECT_EQ(flip(Picture{}, Picture{}).mean, 0) << "nothing at all";
}

TEST(Flip, ExchangingThePicturesChangesNothing) {
  const Picture a = random_picture(90, 30, 4), b = random_picture(90, 30, 5);
  EXPECT_EQ(flip(a, b).error, flip(b, a).error);
}

TEST(Flip, OnePixelIsSeenAroundItAndNowhereElse) {
  const Picture a = random_picture(300, 200, 6);
  Picture b = a;
  const auto changed = static_cast<std::size_t>(3 * (300 * 128 + 191));
  b.samples[changed] = 255 - b.samples[changed];
  const FlipErrors errors = flip(a, b);
  const int radius = FlipFilters(kFlipPixelsPerDegree).radius;
  EXPECT_EQ(radius, 10) << "3 sqrt(0.04 / 2) / pi of a degree is 9.05 pixels";
  int beyond = 0, seen = 0;
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 300; ++x) {
      const bool far = std::abs(x - 191) > radius || std::abs(y - 128) > radius;
      const bool differs = errors.error[static_cast<std::size_t>(300 * y + x)] != 0;
      beyond += far && differs ? 1 : 0;
      seen += !far && differs ? 1 : 0;
    }
  }
  EXPECT_EQ(beyond, 0);
  EXPECT_GT(seen, 100);
}

TEST(Flip, AWorseErrorIsSeenMore) {
  const Picture a = paint(64, 64, [](int x, int) { return Triple{2.0 * x, 90, 90}; });
  double before = 0;
  for (const double change : {2.0, 10.0, 40.0, 120.0}) {
    const double mean = flip(a, paint(64, 64,
                                      [=](int x, int y) {
                                        return Triple{2.0 * x, 90, y > 20 && y < 40 ? 90 + change : 90};
                                      }))
                            .mean;
    EXPECT_GT(mean, before);
    before = mean;
  }
}

TEST(Flip, P99IsTheErrorThatOneInAHundredExceeds) {
  const Picture a = random_picture(50, 40, 7), b = random_picture(50, 40, 8);
  const FlipErrors errors = flip(a, b);
  const auto above =
      std::ranges::count_if(errors.error, [&](float error) { return static_cast<double>(error) > errors.p99; });
  EXPECT_EQ(above, 20);
  Picture nearly = paint(200, 200, [](int, int) { return Triple{50, 50, 50}; });
  const Picture constant = nearly;
  nearly.samples[0] = 255;  // at most 11 x 11 of 40,000 pixels
  EXPECT_EQ(flip(constant, nearly).p99, 0);
  EXPECT_GT(flip(constant, nearly).max, 0);
}

TEST(Flip, FractionsOfALevelCount) {
  Picture a = paint(8, 8, [](int, int) { return Triple{100, 100, 100}; });
  const auto shifted = [&](float by) {
    Picture b = a;
    for (float& sample : b.samples) sample += by;
    return flip(a, b).mean;
  };
  EXPECT_GT(shifted(0.5F), 0);
  EXPECT_LT(shifted(0.5F), shifted(1));
}

TEST(Flip, WhatItIsNotDefinedForIsRefused) {
  const Picture a = random_picture(4, 3, 1);
  Picture linear = a;
  linear.format = PictureFormat::exr;
  EXPECT_THROW(flip(a, random_picture(3, 4, 1)), std::invalid_argument);
  EXPECT_THROW(flip(a, linear), std::invalid_argument);
  for (const double pixels : {0.0, -1.0, 1e9, std::nan("")}) EXPECT_THROW(flip(a, a, pixels), std::invalid_argument);
}

}  // namespace
}  // namespace plumb
