#include "conformance/compare/wrong_regions.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace plumb {
namespace {

/// '#' is wrong.
PixelMask mask_of(const std::vector<std::string>& rows) {
  PixelMask mask{static_cast<int>(rows[0].size()), static_cast<int>(rows.size()), {}};
  for (const std::string& row : rows)
    for (const char c : row) mask.wrong.push_back(c == '#');
  return mask;
}

void expect_region(const WrongRegion& region, int x, int y, int width, int height, int wrong) {
  EXPECT_EQ(region.x, x);
  EXPECT_EQ(region.y, y);
  EXPECT_EQ(region.width, width);
  EXPECT_EQ(region.height, height);
  EXPECT_EQ(region.wrong, wrong);
}

TEST(WrongRegions, BlobsTouchAtCorners) {
  const WrongRegions regions = wrong_regions(mask_of({"#....#",  //
                                                      ".#..#.",  //
                                                      "......",  //
                                                      "###...",  //
                                                      "#.#..#"}),
                                             2);
  EXPECT_EQ(regions.blobs, 4);
  EXPECT_EQ(regions.wrong, 10);
  expect_region(regions.largest_blob, 0, 3, 3, 2, 5);
  expect_region(regions.densest_window, 0, 3, 2, 2, 3);
}

TEST(WrongRegions, TheFirstOfEqualBlobsAndWindowsIsTaken) {
  const WrongRegions regions = wrong_regions(mask_of({"...##",  //
                                                      "#....",  //
                                                      "#...."}),
                                             1);
  expect_region(regions.largest_blob, 3, 0, 2, 1, 2);
  expect_region(regions.densest_window, 3, 0, 1, 1, 1);
}

TEST(WrongRegions, NothingWrongIsEmpty) {
  for (const PixelMask& mask : {mask_of({"....", "...."}), PixelMask{}}) {
    const WrongRegions regions = wrong_regions(mask);
    EXPECT_EQ(regions.blobs, 0);
    EXPECT_EQ(regions.wrong, 0);
    expect_region(regions.largest_blob, 0, 0, 0, 0, 0);
    expect_region(regions.densest_window, 0, 0, 0, 0, 0);
  }
}

TEST(WrongRegions, TheWindowIsCutToThePicture) {
  const WrongRegions regions = wrong_regions(mask_of({"#.#", "..#"}), 16);
  expect_region(regions.densest_window, 0, 0, 3, 2, 3);
}

TEST(WrongRegions, ABlobMayBeAWholeLargePicture) {
  const PixelMask mask{1000, 700, std::vector<std::uint8_t>(700'000, 1)};
  const WrongRegions regions = wrong_regions(mask);
  EXPECT_EQ(regions.blobs, 1);
  expect_region(regions.largest_blob, 0, 0, 1000, 700, 700'000);
  expect_region(regions.densest_window, 0, 0, 16, 16, 256);
}

TEST(WrongCounts, AreThoseOfCounting) {
  std::mt19937 random(1);
  PixelMask mask{13, 9, {}};
  for (int i = 0; i < 13 * 9; ++i) mask.wrong.push_back(random() % 3 == 0);
  const WrongCounts counts(mask);
  int rectangles = 0;
  for (int y0 = 0; y0 <= 9; ++y0) {
    for (int y1 = 0; y1 <= 9; ++y1) {
      for (int x0 = 0; x0 <= 13; ++x0) {
        for (int x1 = 0; x1 <= 13; ++x1, ++rectangles) {
          int wrong = 0;
          for (int y = y0; y < y1; ++y)
            for (int x = x0; x < x1; ++x) wrong += mask.at(x, y) ? 1 : 0;
          ASSERT_EQ(counts.in(x0, y0, x1, y1), wrong) << x0 << " " << y0 << " " << x1 << " " << y1;
        }
      }
    }
  }
  EXPECT_EQ(rectangles, 10 * 10 * 14 * 14);
}

TEST(WrongPixels, AnyChannelPastTheToleranceCounts) {
  const Picture reference{PictureFormat::png, 2, 2, {9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9}, false};
  Picture picture = reference;
  picture.samples = {11, 9, 9, 9, 11.5F, 9, 9, 9, 6, 7, 11, 9};
  EXPECT_EQ(wrong_pixels(reference, picture, 2).wrong, (std::vector<std::uint8_t>{0, 1, 1, 0}));
}

}  // namespace
}  // namespace plumb
