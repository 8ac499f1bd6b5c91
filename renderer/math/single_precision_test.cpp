#include "renderer/math/single_precision.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "renderer/math/vec3.h"

namespace plumb {

// Of rounding_loops_for_tests.cpp, by the level of optimisation.
namespace o2 {
void round_points(std::span<Point3> points);
void round_numbers(std::span<double> numbers);
}  // namespace o2
namespace o3 {
void round_points(std::span<Point3> points);
void round_numbers(std::span<double> numbers);
}  // namespace o3

namespace {

/// A number of which no float is equal, and the float nearest to it: with e the last place of floats, m e + e / 4.
double before(std::size_t i) { return 1 + static_cast<double>(i) * 0x1p-23 + 0x1p-25; }
double after(std::size_t i) { return 1 + static_cast<double>(i) * 0x1p-23; }

TEST(SinglePrecision, LoopsOverPointsRoundAtEveryLevelOfOptimisation) {
  int cases = 0;
  for (const auto round : {o2::round_points, o3::round_points}) {
    std::vector<Point3> points;
    for (std::size_t i = 0; i < 3003; i += 3) points.push_back({before(i), before(i + 1), before(i + 2)});
    round(points);
    for (std::size_t i = 0; i < 3003; ++i, ++cases) ASSERT_EQ(points[i / 3][static_cast<int>(i % 3)], after(i)) << i;
  }
  EXPECT_EQ(cases, 2 * 3003);
}

TEST(SinglePrecision, LoopsOverNumbersRoundAtEveryLevelOfOptimisation) {
  int cases = 0;
  for (const auto round : {o2::round_numbers, o3::round_numbers}) {
    std::vector<double> numbers;
    for (std::size_t i = 0; i < 1001; ++i) numbers.push_back(before(i));
    round(numbers);
    for (std::size_t i = 0; i < 1001; ++i, ++cases) ASSERT_EQ(numbers[i], after(i)) << i;
  }
  EXPECT_EQ(cases, 2 * 1001);
}

TEST(SinglePrecision, TakesTheEvenOneOfTwoAndInfinityBeyondTheRange) {
  EXPECT_EQ(rounded_to_single(1 + 0x1p-24), 1);
  EXPECT_EQ(rounded_to_single(1 + 0x3p-24), 1 + 0x1p-22);
  EXPECT_EQ(rounded_to_single(1e39), std::numeric_limits<double>::infinity());
  EXPECT_EQ(rounded_to_single(-1e39), -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::signbit(rounded_to_single(-0.0)));
  EXPECT_TRUE(std::isnan(rounded_to_single(std::nan(""))));
}

}  // namespace
}  // namespace plumb
