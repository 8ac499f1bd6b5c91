#include "conformance/compare/picture_difference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "conformance/compare/heat_map.h"

namespace plumb {
namespace {

Picture picture(int width, int height, std::vector<float> samples, PictureFormat format = PictureFormat::png) {
  return {format, width, height, std::move(samples), false};
}

TEST(PictureDifference, NumbersAreThoseWorkedOutByHand) {
  // Differences by pixel: (1,0,4), (0,0,0), (3,0,4), (0,2,0).
  const Picture reference = picture(2, 2, {10, 10, 10, 20, 20, 20, 30, 30, 30, 40, 40, 40});
  const Picture other = picture(2, 2, {11, 10, 6, 20, 20, 20, 27, 30, 34, 40, 42, 40});
  const PictureDifference d = difference(reference, other, 2);
  EXPECT_EQ(d.pixels, 4);
  EXPECT_EQ(d.pixels_past, 2);
  EXPECT_EQ(d.max, 4);
  EXPECT_EQ(d.max_x, 0) << "the first pixel that has the largest difference";
  EXPECT_EQ(d.max_y, 0);
  EXPECT_EQ(d.channels[0].max, 3);
  EXPECT_EQ(d.channels[0].mean, 1);                     // (1 + 0 + 3 + 0) / 4
  EXPECT_DOUBLE_EQ(d.channels[0].rms, std::sqrt(2.5));  // (1 + 9) / 4
  EXPECT_EQ(d.channels[0].share_past, 0.25);
  EXPECT_EQ(d.channels[1].max, 2);
  EXPECT_EQ(d.channels[1].mean, 0.5);
  EXPECT_EQ(d.channels[1].rms, 1);
  EXPECT_EQ(d.channels[1].share_past, 0) << "2 is not more than 2";
  EXPECT_EQ(d.channels[2].mean, 2);
  EXPECT_DOUBLE_EQ(d.channels[2].rms, std::sqrt(8.0));  // (16 + 16) / 4
  EXPECT_EQ(d.channels[2].share_past, 0.5);
  EXPECT_EQ(pixel_difference(reference, other, 0, 1), 4);
  EXPECT_EQ(pixel_difference(reference, other, 1, 1), 2);
}

TEST(PictureDifference, EqualPicturesDifferByNothing) {
  const Picture a = picture(3, 1, {1, 2, 3, 4, 5, 6, 7, 8, 9});
  const PictureDifference d = difference(a, a, 0);
  EXPECT_EQ(d.max, 0);
  EXPECT_EQ(d.pixels_past, 0);
  for (const ChannelDifference& c : d.channels) EXPECT_EQ(c.max + c.mean + c.rms + c.share_past, 0);
}

TEST(PictureDifference, ExchangingThePicturesChangesNothing) {
  const Picture a = picture(1, 2, {0, 5, 255, 1, 1, 1});
  const Picture b = picture(1, 2, {255, 6, 0, 1, 1, 3});
  const PictureDifference ab = difference(a, b, 1);
  const PictureDifference ba = difference(b, a, 1);
  EXPECT_EQ(ab.max, 255);
  EXPECT_EQ(ab.max, ba.max);
  EXPECT_EQ(ab.pixels_past, ba.pixels_past);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(ab.channels[c].rms, ba.channels[c].rms);
}

TEST(PictureDifference, FloatsOfAnyMagnitudeAreSubtractedInDouble) {
  const Picture a = picture(1, 1, {3e38F, 0, 0}, PictureFormat::exr);
  const Picture b = picture(1, 1, {-3e38F, 0, 1e-40F}, PictureFormat::exr);
  const PictureDifference d = difference(a, b, 0);
  EXPECT_EQ(d.max, 2 * static_cast<double>(3e38F)) << "past the largest float";
  EXPECT_TRUE(std::isfinite(d.channels[0].rms));
  EXPECT_GT(d.channels[2].max, 0);
}

std::vector<std::uint8_t> levels(std::initializer_list<int> values) { return {values.begin(), values.end()}; }

TEST(HeatMap, RunsFromVioletToWhiteByTheLogarithm) {
  // log2(16) / log2(255) = 0.50035, so 16 levels lie a little past the middle anchor (240,90,30): 0.0014 of the way to
  // (255,190,40).
  const Picture reference = picture(4, 1, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  const Picture other = picture(4, 1, {1, 0, 0, 0, 255, 0, 0, 0, 16, 0, 0.25F, 0});
  EXPECT_EQ(heat_map(reference, other), levels({110, 30, 160, 255, 255, 255, 240, 90, 30, 110, 30, 160}));
}

TEST(HeatMap, EqualPixelsShowTheReferenceDarkAndGrey) {
  // 0.3 * 200 + 0.6 * 100 + 0.1 * 50 = 125; a fifth of it is 25.
  const Picture reference = picture(2, 1, {200, 100, 50, 255, 255, 255});
  EXPECT_EQ(heat_map(reference, reference), levels({25, 25, 25, 51, 51, 51}));
}

TEST(HeatMap, LinearPicturesCountIn255ths) {
  const Picture reference = picture(3, 1, {0, 0, 0, 0.5F, 0.5F, 0.5F, 100, 100, 100}, PictureFormat::exr);
  const Picture other = picture(3, 1, {1, 0, 0, 0.5F, 0.5F, 0.5F, 100, 1000, 100}, PictureFormat::exr);
  EXPECT_EQ(heat_map(reference, other), levels({255, 255, 255, 25, 25, 25, 255, 255, 255}));
}

TEST(FlipMap, GetsBrighterWithTheError) {
  FlipErrors errors{101, 1, {}, 0, 0, 0};
  for (int i = 0; i <= 100; ++i) errors.error.push_back(static_cast<float>(i) / 100);
  const std::vector<std::uint8_t> map = flip_map(errors);
  ASSERT_EQ(map.size(), 303U);
  const auto luminance = [&](std::size_t i) {
    return 0.2126 * map[3 * i] + 0.7152 * map[3 * i + 1] + 0.0722 * map[3 * i + 2];
  };
  EXPECT_EQ(luminance(0), 0);
  for (std::size_t i = 1; i <= 100; ++i) EXPECT_GT(luminance(i), luminance(i - 1)) << i;
  EXPECT_EQ(map[300], 255);
  EXPECT_EQ(map[301], 250);
  EXPECT_EQ(map[302], 190);
}

}  // namespace
}  // namespace plumb
