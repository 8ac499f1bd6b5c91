#include "renderer/film/render.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <set>

#include "renderer/scene_for_tests.h"

namespace plumb {
namespace {

/// Something of everything, in a picture of some tiles, none of them whole at the right and bottom.
ReadScene lively_scene() {
  return scene_of(
      "<image>70 45</image><samples>4</samples><camera><viewPoint>0 0 6</viewPoint></camera><light><position>3 4 "
      "5</position></light>"
      "<shader name='glass' type='Glass'><refractiveIndex>1.5</refractiveIndex></shader>"
      "<surface type='Sphere'><shader ref='glass'/></surface><surface type='Box'><minPt>-4 -1.5 -4</minPt><maxPt>4 -1 "
      "4</maxPt></surface>"
      "<surface type='Group'><translate>1 1 -2</translate><rotate>30 40 50</rotate><surface type='Cylinder'><shader "
      "type='Phong'/></surface></surface>");
}

TEST(Render, HasTheSameBitsAndCountsOnAnyNumberOfThreads) {
  const ReadScene read = lively_scene();
  const Rendering one = render(read.scene, {.threads = 1, .crop = {}, .progress = {}});
  std::set<double> values;
  for (const Color& c : one.image.pixels()) values.insert(c.r);
  EXPECT_GT(values.size(), 300u) << "the picture is not blank";
  for (const int threads : {2, 7, 0}) {
    const Rendering several = render(read.scene, {.threads = threads, .crop = {}, .progress = {}});
    EXPECT_TRUE(same_bits(one.image, several.image)) << threads;
    EXPECT_EQ(one.counters, several.counters) << threads;
  }
  EXPECT_EQ(one.counters.rays[0], 70u * 45u * 4u);
}

TEST(Render, ACropIsThatPartOfTheWhole) {
  const ReadScene read = lively_scene();
  const Image whole = render(read.scene, {}).image;
  int crops = 0;
  for (const PixelRect& crop :
       {PixelRect{0, 0, 1, 1}, PixelRect{69, 44, 1, 1}, PixelRect{20, 10, 40, 33}, PixelRect{0, 0, 70, 45}}) {
    const Image part = render(read.scene, {.threads = 2, .crop = crop, .progress = {}}).image;
    ASSERT_EQ(part.width(), crop.width);
    ASSERT_EQ(part.height(), crop.height);
    for (int y = 0; y < crop.height; ++y)
      for (int x = 0; x < crop.width; ++x) EXPECT_EQ(part.at(x, y), whole.at(crop.x + x, crop.y + y));
    ++crops;
  }
  EXPECT_EQ(crops, 4);
}

TEST(Render, SampleGridIsTheRoundedRoot) {
  EXPECT_EQ(sample_grid(0), 1);
  EXPECT_EQ(sample_grid(1), 1);
  EXPECT_EQ(sample_grid(2), 1);
  EXPECT_EQ(sample_grid(3), 2);
  EXPECT_EQ(sample_grid(6), 2);
  EXPECT_EQ(sample_grid(7), 3);
  EXPECT_EQ(sample_grid(8), 3);
  EXPECT_EQ(sample_grid(10), 3);
  EXPECT_EQ(sample_grid(12), 3);
  EXPECT_EQ(sample_grid(13), 4);
  EXPECT_EQ(sample_grid(16), 4);
}

TEST(Render, TopRowIsNearTheTopOfTheWindow) {
  // A ball in the middle of the upper left pixel: (-3/8, 3/8) in the window.
  const ReadScene read = scene_of(
      "<image>4 4</image><light/><surface type='Sphere'><center>-1.875 1.875 -5</center><radius>.5</radius></surface>");
  const Image image = render(read.scene, {}).image;
  int lit = 0;
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x) lit += image.at(x, y).r > 0;
  EXPECT_GT(image.at(0, 0).r, 0);
  EXPECT_EQ(lit, 1);
}

TEST(Render, SamplesLieInTheMiddlesOfAGrid) {
  // One pixel over a window of width 1 at distance 1. A wall at z = -1 is lit for x < 0.2 only, as a box beyond the
  // window hides the rest: with 3 x 3 samples the columns stand at x = -1/3, 0, 1/3.
  const auto brightness = [](const std::string& samples) {
    const ReadScene read =
        scene_of("<image>1 1</image><samples>" + samples +
                 "</samples><light/><surface type='Box'><minPt>-9 -9 -1.5</minPt><maxPt>.2 9 -1</maxPt>"
                 "<shader type='Phong'><diffuseColor>0 0 0</diffuseColor><exponent>0</exponent></shader></surface>");
    return render(read.scene, {}).image.at(0, 0).g;
  };
  EXPECT_EQ(brightness("1"), 1);
  EXPECT_EQ(brightness("4"), 0.5);  // columns at -1/4 and 1/4
  EXPECT_NEAR(brightness("9"), 2.0 / 3, 1e-15);
  EXPECT_NEAR(brightness("8"), 2.0 / 3, 1e-15);
}

TEST(Render, ProgressRisesToOneAndNeverFromTwoThreadsAtOnce) {
  std::atomic<int> inside{0};
  std::vector<double> shares;
  render(lively_scene().scene, {.threads = 4, .crop = {}, .progress = [&](double share) {
                                  EXPECT_EQ(++inside, 1);
                                  shares.push_back(share);
                                  --inside;
                                }});
  ASSERT_EQ(shares.size(), 6u) << "one a tile, 3 x 2";
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_EQ(shares.back(), 1);
}

TEST(Tiles, CoverTheRectangleOnceInRows) {
  for (const PixelRect& rect :
       {PixelRect{0, 0, 1, 1}, PixelRect{5, 7, 32, 32}, PixelRect{5, 7, 33, 65}, PixelRect{0, 0, 100, 31}}) {
    std::vector<int> covered(static_cast<std::size_t>(rect.width) * static_cast<std::size_t>(rect.height));
    for (const PixelRect& tile : tiles_of(rect)) {
      EXPECT_LE(tile.width, 32);
      EXPECT_LE(tile.height, 32);
      for (int y = tile.y; y < tile.y + tile.height; ++y)
        for (int x = tile.x; x < tile.x + tile.width; ++x)
          ++covered.at(static_cast<std::size_t>((y - rect.y) * rect.width + x - rect.x));
    }
    EXPECT_EQ(std::count(covered.begin(), covered.end(), 1), static_cast<std::ptrdiff_t>(covered.size()));
  }
  EXPECT_TRUE(tiles_of({3, 3, 0, 5}).empty());
}

TEST(ForEachItem, CallsEveryItemOnceOnWorkersInRange) {
  for (const int threads : {1, 2, 7}) {
    for (const int count : {0, 1, 5, 1000}) {
      std::vector<std::atomic<int>> calls(static_cast<std::size_t>(count));
      std::atomic<int> wrong_worker{0};
      for_each_item(threads, count, [&](int worker, int item) {
        ++calls[static_cast<std::size_t>(item)];
        if (worker < 0 || worker >= threads) ++wrong_worker;
      });
      for (const auto& c : calls) EXPECT_EQ(c, 1);
      EXPECT_EQ(wrong_worker, 0);
    }
  }
}

TEST(ForEachItem, PassesOnTheFirstException) {
  for (const int threads : {1, 3}) {
    std::atomic<int> calls{0};
    const auto work = [&](int, int item) {
      ++calls;
      if (item >= 10) throw std::runtime_error("item");
    };
    EXPECT_THROW(for_each_item(threads, 100000, work), std::runtime_error);
    EXPECT_GE(calls, 11);
    EXPECT_LE(calls, 10 + threads) << "each worker stops after its item";
  }
}

}  // namespace
}  // namespace plumb
