#include "conformance/compare/float_lanes.h"

#include <gtest/gtest.h>

#include <limits>

namespace plumb {
namespace {

/// Calls `check` with every `step`-th float of a range, as the double that it is; returns how many.
template <class Check>
int for_floats(float from, float to, std::uint32_t step, const Check& check) {
  int count = 0;
  for (auto bits = std::bit_cast<std::uint32_t>(from); bits <= std::bit_cast<std::uint32_t>(to); bits += step, ++count)
    check(std::bit_cast<float>(bits));
  return count;
}

TEST(FloatLanes, LogarithmIsWithinItsBound) {
  const int count = for_floats(std::numeric_limits<float>::min(), 3e38F, 20011, [](float x) {
    const double right = std::log2(static_cast<double>(x));
    ASSERT_LE(std::fabs(static_cast<double>(log2_of(all_lanes(x))[0]) - right), 2e-7 + 0x1p-24 * std::fabs(right)) << x;
  });
  EXPECT_GT(count, 100'000);
}

TEST(FloatLanes, PowerOfTwoIsWithinItsBound) {
  int count = 0;
  for (float x = -126; x <= 127; x += 0.00193F, ++count) {
    const double right = std::exp2(static_cast<double>(x));
    ASSERT_LE(std::fabs(static_cast<double>(exp2_of(all_lanes(x))[2]) / right - 1), 3e-7) << x;
  }
  EXPECT_GT(count, 100'000);
}

TEST(FloatLanes, CubeRootIsWithinItsBound) {
  const int count = for_floats(1e-6F, 1e6F, 3001, [](float x) {
    const double right = std::cbrt(static_cast<double>(x));
    ASSERT_LE(std::fabs(static_cast<double>(cube_root_of(all_lanes(x))[3]) / right - 1), 3e-7) << x;
  });
  EXPECT_GT(count, 100'000);
}

TEST(FloatLanes, PowerFollowsFromLogarithmAndPowerOfTwo) {
  // The logarithm's error times the exponent (at most 1 here) and ln 2, its rounding, and the power's own error:
  // |log2 x| <= 100, so (2e-7 + 101 * 2^-24 + 100 * 2^-24) * 0.7 + 3e-7 < 9e-6.
  int count = 0;
  for (const float exponent : {0.25F, 0.7F, 1.0F}) {
    count += for_floats(1.1e-30F, 100.0F, 20011, [&](float x) {
      const double right = std::pow(static_cast<double>(x), static_cast<double>(exponent));
      ASSERT_LE(std::fabs(static_cast<double>(power_of(all_lanes(x), all_lanes(exponent))[1]) / right - 1), 9e-6)
          << x << " ^ " << exponent;
    });
  }
  EXPECT_GT(count, 100'000);
}

TEST(FloatLanes, LanesAreIndependent) {
  const Lanes power = power_of(Lanes{0, 1, 4, 1e-31F}, Lanes{0.5F, 0.7F, 0.5F, 0.1F});
  EXPECT_EQ(power[0], 0);
  EXPECT_EQ(power[1], 1);
  EXPECT_NEAR(power[2], 2, 1e-6);
  EXPECT_EQ(power[3], 0);
  const Lanes root = root_of(Lanes{4, 9, 0, 2});
  EXPECT_EQ(root[0], 2);
  EXPECT_EQ(root[1], 3);
  EXPECT_EQ(root[2], 0);
  EXPECT_EQ(root[3], std::sqrt(2.0F));
}

}  // namespace
}  // namespace plumb
