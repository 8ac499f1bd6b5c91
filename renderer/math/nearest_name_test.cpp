#include "renderer/math/nearest_name.h"

#include <gtest/gtest.h>

#include <array>

namespace plumb {
namespace {

constexpr std::array<std::string_view, 4> kTags{"center", "radius", "height", "minPt"};

TEST(NearestName, FindsMisspellingsAndIgnoresCase) {
  EXPECT_EQ(nearest_name("centre", kTags), "center");
  EXPECT_EQ(nearest_name("RADUIS", kTags), "radius");
  EXPECT_EQ(did_you_mean("heigth", kTags), "; did you mean 'height'?");
}

TEST(NearestName, StaysSilentOnStrangers) {
  EXPECT_EQ(nearest_name("viewDirection", kTags), "");
  EXPECT_EQ(nearest_name("x", kTags), "");
  EXPECT_EQ(did_you_mean(std::string(1000, 'a'), kTags), "");
}

TEST(NearestName, ComparesWithoutCase) {
  EXPECT_TRUE(equal_ignoring_case("minpt", "minPt"));
  EXPECT_FALSE(equal_ignoring_case("minpt", "minPts"));
}

}  // namespace
}  // namespace plumb
