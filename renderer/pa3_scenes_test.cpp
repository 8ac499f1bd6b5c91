#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "renderer/scene_for_tests.h"

// The grading scenes: that they say what they mean, and that their pictures can show a mistake.

namespace plumb {
namespace {

constexpr const char* kFolder = PLUMB_SOURCE_DIR "/scenes/pa3";

std::vector<std::string> scene_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder))
    if (entry.path().extension() == ".xml") names.push_back(entry.path().stem().string());
  std::ranges::sort(names);
  return names;
}

bool is_finite(const Color& c) { return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b); }

/// The weights of Rec. 709.
double luminance(const Color& c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; }

/// How much of a picture tells little: a wrong black or clamped pixel often stays what it was.
struct Shares {
  double black = 0, clamped = 0;
  double median_of_the_rest = 0;
};

Shares shares_of(const Image& image) {
  std::vector<double> seen;
  Shares shares;
  for (const Color& c : image.pixels()) {
    if (luminance(c) == 0)
      ++shares.black;
    else
      seen.push_back(luminance(c));
    if (std::max({c.r, c.g, c.b}) > 1) ++shares.clamped;
  }
  const auto count = static_cast<double>(image.pixels().size());
  shares.black /= count;
  shares.clamped /= count;
  std::ranges::sort(seen);
  if (!seen.empty()) shares.median_of_the_rest = seen[seen.size() / 2];
  return shares;
}

class Pa3Scene : public ::testing::TestWithParam<std::string> {};

TEST_P(Pa3Scene, IsReadWithoutWarningsAndShowsSomethingEverywhere) {
  const ReadScene read = read_and_build(std::filesystem::path(kFolder) / (GetParam() + ".xml"));
  EXPECT_THAT(read.warnings, ::testing::IsEmpty());
  const Image image = render(read.scene, {.threads = 0, .crop = {}, .progress = {}}).image;
  EXPECT_NE(image.width(), image.height()) << "a transposed picture would have the right size";
  EXPECT_TRUE(std::ranges::all_of(image.pixels(), is_finite));
  const Shares shares = shares_of(image);
  EXPECT_LT(shares.black, 0.6);
  EXPECT_LT(shares.clamped, 0.06);
  // Between the levels 64 and 212 of grey.
  EXPECT_GT(shares.median_of_the_rest, 0.048);
  EXPECT_LT(shares.median_of_the_rest, 0.67);
}

std::string test_name(const ::testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::ranges::replace(name, '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, Pa3Scene, ::testing::ValuesIn(scene_names()), test_name);

TEST(Pa3Scenes, AreAsManyAsTheSuiteWasMadeFor) { EXPECT_EQ(scene_names().size(), 34U); }

TEST(Pa3Scenes, SharesTellBlackAndClampedPixels) {
  Image image(2, 2);
  image.at(0, 0) = {0.5, 0.5, 0.5};
  image.at(1, 1) = {0.1, 1.5, 0};
  const Shares shares = shares_of(image);
  EXPECT_EQ(shares.black, 0.5);
  EXPECT_EQ(shares.clamped, 0.25);
  EXPECT_NEAR(shares.median_of_the_rest, 0.2126 * 0.1 + 0.7152 * 1.5, 1e-15);
}

}  // namespace
}  // namespace plumb
