#include "conformance/compare/picture_faults.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "renderer/image/image.h"

namespace plumb {
namespace {

using testing::HasSubstr;

/// A scene without symmetry, in linear colours over the whole plane, so that it can be sampled anywhere: a shaded disk
/// and a bright bar on a ramp. The unit is a pixel.
Color scene_at(double x, double y) {
  const double dx = (x - 31) / 17, dy = (y - 26) / 17, rr = dx * dx + dy * dy;
  if (rr < 1) {
    const double light = std::max(0.0, 0.3 * dx - 0.5 * dy + 0.8 * std::sqrt(1 - rr));
    return {0.9 * light, 0.5 * light + 0.02, 0.15 * light + 0.05};
  }
  if (std::fabs(x + 0.4 * y - 70) < 4) return {0.1, 0.7, 0.9};
  return {0.1 + 0.002 * y, 0.2, 0.3 - 0.001 * x};
}

using Sampler = std::function<Color(int, int)>;

Picture picture_of(int width, int height, const Sampler& color) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) image.at(x, y) = color(x, y);
  const auto levels = levels_of(image);
  return {PictureFormat::png, width, height, {levels.begin(), levels.end()}, false};
}

/// The mean of n x n samples of each pixel, the scene moved by (right, down).
Sampler rendering(double right = 0, double down = 0, int n = 1) {
  return [=](int x, int y) {
    Color sum;
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) sum = sum + scene_at(x + (i + 0.5) / n - right, y + (j + 0.5) / n - down);
    return (1.0 / (n * n)) * sum;
  };
}

constexpr int kWidth = 96, kHeight = 64;
Picture render(double right = 0, double down = 0, int n = 1) {
  return picture_of(kWidth, kHeight, rendering(right, down, n));
}

/// Each pixel, with three levels, made from the picture.
Picture changed(const Picture& from, const std::function<void(int, int, float*)>& change) {
  Picture to = from;
  for (int y = 0; y < to.height; ++y)
    for (int x = 0; x < to.width; ++x)
      change(x, y, to.samples.data() + 3 * (static_cast<std::ptrdiff_t>(y) * to.width + x));
  return to;
}

Picture moved(const Picture& from, const std::function<const float*(int, int)>& source) {
  return changed(from, [&](int x, int y, float* levels) { std::copy_n(source(x, y), 3, levels); });
}

/// That `fault` is the first answer and explains at least `least`; and that an equal picture has none.
FoundFault expect_fault(const Picture& reference, const Picture& picture, PictureFault fault, double least,
                        double tolerance = 0) {
  const auto found = picture_faults(reference, picture, tolerance);
  EXPECT_FALSE(found.empty()) << to_string(fault);
  if (found.empty()) return {};
  EXPECT_EQ(to_string(found[0].fault), to_string(fault)) << found[0].sentence;
  EXPECT_GE(found[0].explained, least) << to_string(fault);
  EXPECT_LE(found[0].explained, 1) << to_string(fault);
  return found[0];
}

void expect_none(const Picture& reference, const Picture& picture, double tolerance = 0) {
  for (const FoundFault& fault : picture_faults(reference, picture, tolerance))
    ADD_FAILURE() << to_string(fault.fault) << " " << fault.explained << ": " << fault.sentence;
}

TEST(PictureFaults, EveryWholeShiftIsFound) {
  int shifts = 0;
  for (int dy = -3; dy <= 3; ++dy) {
    for (int dx = -3; dx <= 3; ++dx) {
      if (dx == 0 && dy == 0) continue;
      ++shifts;
      const FoundFault fault = expect_fault(render(), render(dx, dy), PictureFault::shift, 1);
      EXPECT_THAT(fault.sentence, HasSubstr("the whole picture lies "));
      EXPECT_EQ(fault.sentence.find("right") != std::string::npos, dx > 0) << fault.sentence;
      EXPECT_EQ(fault.sentence.find("left") != std::string::npos, dx < 0);
      EXPECT_EQ(fault.sentence.find("low") != std::string::npos, dy > 0);
      EXPECT_EQ(fault.sentence.find("high") != std::string::npos, dy < 0);
    }
  }
  EXPECT_EQ(shifts, 48);
  EXPECT_EQ(picture_faults(render(), render(1, -2), 0)[0].sentence,
            "the whole picture lies 1 pixel too far to the right and 2 pixels too high");
  for (const FoundFault& fault : picture_faults(render(), render(5, 0), 0)) EXPECT_NE(fault.fault, PictureFault::shift);
}

TEST(PictureFaults, HalfAPixelIsFoundWithAndWithoutAntialiasing) {
  int shifts = 0;
  for (const int n : {1, 3}) {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        if (dx == 0 && dy == 0) continue;
        ++shifts;
        const FoundFault fault =
            expect_fault(render(0, 0, n), render(0.5 * dx, 0.5 * dy, n), PictureFault::half_pixel_shift, 0.3);
        EXPECT_EQ(fault.sentence.find("right") != std::string::npos, dx > 0) << fault.sentence;
        EXPECT_EQ(fault.sentence.find("left") != std::string::npos, dx < 0) << fault.sentence;
        EXPECT_EQ(fault.sentence.find("downwards") != std::string::npos, dy > 0) << fault.sentence;
        EXPECT_EQ(fault.sentence.find("upwards") != std::string::npos, dy < 0) << fault.sentence;
      }
    }
  }
  EXPECT_EQ(shifts, 16);
}

TEST(PictureFaults, MirroredAndTurnedPicturesAreFound) {
  const Picture reference = picture_of(64, 64, rendering(-12, 5));
  const auto expect = [&](PictureFault fault, const std::function<const float*(int, int)>& source) {
    expect_fault(reference, moved(reference, source), fault, 1);
  };
  expect(PictureFault::flip_left_right, [&](int x, int y) { return reference.pixel(63 - x, y); });
  expect(PictureFault::flip_top_bottom, [&](int x, int y) { return reference.pixel(x, 63 - y); });
  expect(PictureFault::rotation_180, [&](int x, int y) { return reference.pixel(63 - x, 63 - y); });
  expect(PictureFault::transposition, [&](int x, int y) { return reference.pixel(y, x); });
  expect_none(reference, moved(reference, [&](int x, int y) { return reference.pixel(63 - y, x); }));
}

TEST(PictureFaults, ExchangedSidesAreATranspositionIfThePixelsAre) {
  const Picture reference = render();
  const Sampler straight = rendering();
  const auto transposed = picture_of(kHeight, kWidth, [&](int x, int y) { return straight(y, x); });
  const FoundFault fault = expect_fault(reference, transposed, PictureFault::transposition, 1);
  EXPECT_THAT(fault.sentence, HasSubstr("width and height"));
  expect_none(reference, picture_of(kHeight, kWidth, straight));
  expect_none(reference, picture_of(kHeight, kWidth, [](int, int) { return Color(); }));
  expect_none(reference, picture_of(50, 50, straight));
  const auto constant = [](int, int) { return Color{0.5, 0.5, 0.5}; };
  expect_none(picture_of(20, 30, constant), picture_of(30, 20, constant));
}

TEST(PictureFaults, GammaThatIsMissingOrAppliedTwiceIsFound) {
  for (const int n : {1, 3}) {
    const auto raised = [&](double exponent) {
      const Sampler linear = rendering(0, 0, n);
      return picture_of(kWidth, kHeight, [&](int x, int y) {
        const Color c = linear(x, y);
        return Color{std::pow(c.r, exponent), std::pow(c.g, exponent), std::pow(c.b, exponent)};
      });
    };
    expect_fault(render(0, 0, n), raised(2.2), PictureFault::missing_gamma, 1);
    expect_fault(render(0, 0, n), raised(1 / 2.2), PictureFault::double_gamma, 0.9);
    for (const double exponent : {1.1, 1.8, 2.5, 0.7}) expect_none(render(0, 0, n), raised(exponent));
  }
}

TEST(PictureFaults, EveryOrderOfChannelsIsFound) {
  const Picture reference = render();
  std::array<int, 3> order{0, 1, 2};
  int orders = 0;
  while (std::ranges::next_permutation(order).found) {
    ++orders;
    const Picture swapped = changed(reference, [&](int x, int y, float* levels) {
      for (int c = 0; c < 3; ++c) levels[c] = reference.pixel(x, y)[order[static_cast<std::size_t>(c)]];
    });
    const FoundFault fault = expect_fault(reference, swapped, PictureFault::swapped_channels, 1);
    if (order == std::array{2, 1, 0}) {
      EXPECT_EQ(fault.sentence, "the channels are written in the order blue, green, red");
    }
  }
  EXPECT_EQ(orders, 5);
}

TEST(PictureFaults, BlackLinesAtTheBorderAreNamed) {
  const Picture reference = render();
  const auto black = [](float* levels) { std::fill_n(levels, 3, 0.0F); };
  const Picture bottom = changed(reference, [&](int, int y, float* p) { return y == kHeight - 1 ? black(p) : void(); });
  EXPECT_EQ(expect_fault(reference, bottom, PictureFault::black_border, 1).sentence, "the bottom row is black");
  const Picture two = changed(reference, [&](int x, int y, float* p) { return x == 0 || y == 0 ? black(p) : void(); });
  EXPECT_EQ(expect_fault(reference, two, PictureFault::black_border, 1).sentence,
            "the top row and the leftmost column are black");
  expect_none(reference, changed(reference, [&](int, int y, float* p) { return y == 20 ? black(p) : void(); }));
  expect_none(reference, changed(reference, [&](int, int y, float* p) { return y < 5 ? black(p) : void(); }));
}

TEST(PictureFaults, AnEnlargedPictureIsFound) {
  const Picture reference = render(0, 0, 3);
  for (const int side : {2, 3, 4}) {
    const Picture first =
        moved(reference, [&](int x, int y) { return reference.pixel(x / side * side, y / side * side); });
    EXPECT_THAT(expect_fault(reference, first, PictureFault::enlarged, 1).sentence,
                HasSubstr("blocks of " + std::to_string(side)));
    // Rendered small: a sample in the middle of each block, which is often no pixel of the reference.
    const Picture small = picture_of(
        kWidth, kHeight, [&](int x, int y) { return scene_at((x / side + 0.5) * side, (y / side + 0.5) * side); });
    expect_fault(reference, small, PictureFault::enlarged, 0.75, 1);
  }
}

TEST(PictureFaults, AntialiasingIsNoShift) {
  // What a correct program may do at edges, in both directions, and what a wrong one does to them.
  for (const int n : {2, 3, 4}) {
    expect_none(render(), render(0, 0, n));
    expect_none(render(0, 0, n), render());
  }
  const Picture reference = render();
  expect_none(reference, changed(reference, [&](int x, int y, float* levels) {
                for (int c = 0; c < 3; ++c) {
                  float sum = 0;
                  for (int j = -1; j <= 1; ++j)
                    for (int i = -1; i <= 1; ++i)
                      sum += reference.pixel(std::clamp(x + i, 0, kWidth - 1), std::clamp(y + j, 0, kHeight - 1))[c];
                  levels[c] = std::round(sum / 9);
                }
              }));
}

TEST(PictureFaults, OtherMistakesHaveNoSimpleName) {
  const Picture reference = render();
  std::mt19937 random(1);
  const auto noise = [&](unsigned range) { return static_cast<float>(random() % range); };
  expect_none(reference, changed(reference, [&](int, int, float* p) {
                for (int c = 0; c < 3; ++c) p[c] = std::min(p[c] + noise(21), 255.0F);
              }));
  expect_none(reference, changed(reference, [&](int, int, float* p) {
                for (int c = 0; c < 3; ++c) p[c] = noise(256);
              }));
  // A noisy reference beside another noise: means of neighbours are nearer to it, to whatever side.
  const Picture noisy = changed(reference, [&](int, int, float* p) {
    for (int c = 0; c < 3; ++c) p[c] = noise(256);
  });
  expect_none(noisy, changed(noisy, [&](int, int, float* p) {
                for (int c = 0; c < 3; ++c) p[c] = noise(256);
              }));
  for (const float factor : {0.5F, 0.9F, 1.1F})
    expect_none(reference, changed(reference, [&](int, int, float* p) {
                  for (int c = 0; c < 3; ++c) p[c] = std::min(std::round(p[c] * factor), 255.0F);
                }));
  expect_none(reference, picture_of(kWidth, kHeight, [](int, int) { return Color(); }));
}

TEST(PictureFaults, WhatIsMissingAtTheBorderCouldHaveMovedOutButIsNoShift) {
  // On an empty ground, a bar at the right border that is not there.
  for (int width = 1; width <= 8; ++width) {
    const auto bar = [&](int x, int) { return x >= 40 - width ? Color{1, 1, 1} : Color{0.2, 0.2, 0.2}; };
    expect_none(picture_of(40, 40, bar), picture_of(40, 40, [](int, int) { return Color{0.2, 0.2, 0.2}; }));
  }
}

TEST(PictureFaults, EqualOrTooFewWrongPixelsAreNoEvidence) {
  const Picture reference = render();
  expect_none(reference, reference);
  expect_none(reference, render(1, 0), 255);
  const auto dot = [](int at) {
    return picture_of(30, 30, [=](int x, int y) { return x == at && y < 15 ? Color{1, 1, 1} : Color(); });
  };
  expect_none(dot(10), dot(11));
  expect_none(Picture{}, Picture{});
}

TEST(PictureFaults, OfASymmetricReferenceBothAnswersAreGiven) {
  const auto ramp = [](int, int y) { return Color{0.01 * y, 0.3, 0.3}; };
  const auto upside_down = [](int, int y) { return Color{0.01 * (39 - y), 0.3, 0.3}; };
  const auto found = picture_faults(picture_of(40, 40, ramp), picture_of(40, 40, upside_down), 0);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].fault, PictureFault::flip_top_bottom);
  EXPECT_EQ(found[1].fault, PictureFault::rotation_180);
}

TEST(PictureFaults, TheToleranceHidesSmallerDifferences) {
  const Picture reference = render();
  std::mt19937 random(2);
  const Picture shifted = render(2, 1);
  const Picture noisy = changed(shifted, [&](int, int, float* p) {
    for (int c = 0; c < 3; ++c) p[c] = std::clamp(p[c] + static_cast<float>(random() % 3) - 1, 0.0F, 255.0F);
  });
  expect_none(reference, noisy);
  expect_fault(reference, noisy, PictureFault::shift, 1, 1);
}

}  // namespace
}  // namespace plumb
