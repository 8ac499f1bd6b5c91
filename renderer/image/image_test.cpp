#include "renderer/image/image.h"

#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <limits>

#include "renderer/image/picture_bytes_for_tests.h"
#include "renderer/image/read_picture.h"
#include "renderer/image/write_image.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// The course's rule, step by step as SEMANTICS has it, in `Real` after the rounding to float.
template <class Real>
int level_by(double linear) {
  const double encoded = std::pow(linear, 1 / 2.2);
  const float stored = static_cast<float>(std::min(std::max(encoded, 0.0), 1.0));
  const Real scaled = static_cast<Real>(stored) * 255;
  return static_cast<int>(std::floor(static_cast<double>(static_cast<Real>(scaled + static_cast<Real>(0.5)))));
}

TEST(LevelOf, KnownValues) {
  EXPECT_EQ(level_of(0), 0);
  EXPECT_EQ(level_of(1), 255);
  EXPECT_EQ(level_of(0.5), 186);   // 255 * 0.5^(1/2.2) = 186.08
  EXPECT_EQ(level_of(0.25), 136);  // 135.79
  EXPECT_EQ(level_of(0.01), 31);   // 31.44
  EXPECT_EQ(level_of(1e-9), 0);
}

TEST(LevelOf, ClampsAndTakesNanAsBlack) {
  EXPECT_EQ(level_of(1.0000001), 255);
  EXPECT_EQ(level_of(1e300), 255);
  EXPECT_EQ(level_of(std::numeric_limits<double>::infinity()), 255);
  EXPECT_EQ(level_of(-1e-300), 0);
  EXPECT_EQ(level_of(-std::numeric_limits<double>::infinity()), 0);
  EXPECT_EQ(level_of(-5), 0);
  EXPECT_EQ(level_of(std::nan("")), 0);
}

TEST(LevelOf, FollowsTheCoursesRuleUpToTheLastBit) {
  // Around each threshold between two levels, float arithmetic or doubles all the way would decide some cases
  // differently; the scan must have met both.
  int cases = 0, float_differs = 0, double_differs = 0;
  for (int level = 0; level < 255; ++level) {
    const double threshold = std::pow((level + 0.5) / 255, 2.2);
    for (int step = -2000; step <= 2000; ++step, ++cases) {
      const double linear = threshold * (1 + step * 1e-10);
      const int expected = level_by<double>(linear);
      ASSERT_EQ(level_of(linear), expected) << std::hexfloat << linear;
      float_differs += level_by<float>(linear) != expected;
      double_differs += static_cast<int>(std::floor(255 * std::pow(linear, 1 / 2.2) + 0.5)) != expected;
    }
  }
  EXPECT_EQ(cases, 255 * 4001);
  EXPECT_GT(float_differs, 0);
  EXPECT_GT(double_differs, 0);
}

TEST(LevelOf, RisesWithTheColor) {
  int last = 0, rises = 0;
  for (int i = 0; i <= 20000; ++i) {
    const int level = level_of(i / 20000.0);
    ASSERT_GE(level, last);
    rises += level > last;
    last = level;
  }
  EXPECT_EQ(last, 255);
  EXPECT_GT(rises, 240);
}

/// 3 x 2 pixels, each channel with a value of its own.
Image sample_image() {
  Image image(3, 2);
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 3; ++x) image.at(x, y) = {0.1 * x, 0.3 * y + 0.05, 0.7 - 0.2 * x};
  return image;
}

TEST(Image, BeginsBlackWithRowZeroFirst) {
  Image image(2, 2);
  EXPECT_EQ(image.at(1, 1), Color{});
  image.at(1, 0) = {1, 0.5, 0};
  EXPECT_THAT(levels_of(image), ElementsAre(0, 0, 0, 255, 186, 0, 0, 0, 0, 0, 0, 0));
}

TEST(WriteImage, PngComesBackAsTheLevels) {
  const Image image = sample_image();
  const auto file = picture_test_file("a.PNG");
  write_image(image, file);
  const Picture picture = read_picture(file);
  EXPECT_EQ(picture.format, PictureFormat::png);
  EXPECT_EQ(picture.width, 3);
  EXPECT_EQ(picture.height, 2);
  EXPECT_FALSE(picture.transparent);
  const std::vector<std::uint8_t> levels = levels_of(image);
  EXPECT_EQ(picture.samples, std::vector<float>(levels.begin(), levels.end()));
  EXPECT_EQ(picture.pixel(2, 1)[0], static_cast<float>(level_of(image.at(2, 1).r)));
}

TEST(WriteImage, ExrComesBackAsLinearFloatsNanAndInfinityIncluded) {
  Image image = sample_image();
  image.at(0, 0) = {std::nan(""), -2.5, 1e30};
  image.at(1, 0).g = std::numeric_limits<double>::infinity();
  const auto file = picture_test_file("a.exr");
  write_image(image, file);
  const Picture picture = read_picture(file);
  EXPECT_TRUE(picture.is_linear());
  EXPECT_TRUE(std::isnan(picture.pixel(0, 0)[0]));
  EXPECT_EQ(picture.pixel(0, 0)[1], -2.5F);
  EXPECT_EQ(picture.pixel(0, 0)[2], 1e30F);
  EXPECT_TRUE(std::isinf(picture.pixel(1, 0)[1]));
  EXPECT_EQ(picture.pixel(2, 1)[1], 0.35F);
}

TEST(WriteImage, TheSameImageGivesTheSameBytes) {
  for (const std::string name : {"same.png", "same.exr"}) {
    write_image(sample_image(), picture_test_file(name));
    const std::string first = bytes_of(picture_test_file(name));
    write_image(sample_image(), picture_test_file(name));
    EXPECT_EQ(bytes_of(picture_test_file(name)), first);
    EXPECT_FALSE(first.empty());
  }
}

std::string refusal(const std::string& name) {
  std::string message;
  try {
    require_image_writable(picture_test_file(name));
  } catch (const InputError& error) {
    message = error.what();
  }
  // Asking beforehand must say the same as trying.
  try {
    write_image(sample_image(), picture_test_file(name));
    EXPECT_EQ(message, "");
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), message);
  }
  return message;
}

TEST(WriteImage, RefusesOtherEndingsAndPlacesThatDoNotExist) {
  EXPECT_THAT(refusal("a.jpg"), HasSubstr("unknown kind of picture '.jpg', expected .png or .exr"));
  EXPECT_THAT(refusal("a"), HasSubstr("unknown kind of picture ''"));
  EXPECT_THAT(refusal("none/a.png"), HasSubstr("does not exist"));
  std::filesystem::create_directories(picture_test_file("folder.png"));
  EXPECT_THAT(refusal("folder.png"), HasSubstr("this is a folder"));
  EXPECT_EQ(refusal("good.png"), "");
}

bool is_in_memory(const std::string& library) {
  const std::string maps = bytes_of("/proc/self/maps");
  return maps.find(library) != std::string::npos;
}

/// In a process of its own, because other tests load the module.
TEST(PictureModule, IsLoadedByTheFirstPictureThatNeedsIt) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto png_then_exr = [] {
    write_image(sample_image(), picture_test_file("a.png"));
    read_picture(picture_test_file("a.png"));
    const bool for_png = is_in_memory("libOpenImageIO");
    write_image(sample_image(), picture_test_file("a.exr"));
    std::_Exit(for_png ? 1 : is_in_memory("libOpenImageIO") ? 0 : 2);
  };
  EXPECT_EXIT(png_then_exr(), ::testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace plumb
