#include "meshes/generators/correctly_rounded.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace plumb {
namespace {

TEST(PartsOfATurn, AreExactWhereTheyCanBe) {
  const std::vector<SinCos> twelfths = parts_of_a_turn(12);
  ASSERT_EQ(twelfths.size(), 12);
  EXPECT_EQ(twelfths[0].sin, 0);
  EXPECT_EQ(twelfths[0].cos, 1);
  EXPECT_EQ(twelfths[1].sin, 0.5);
  EXPECT_EQ(twelfths[3].sin, 1);
  EXPECT_EQ(twelfths[3].cos, 0);
  EXPECT_EQ(twelfths[4].cos, -0.5);
  EXPECT_EQ(twelfths[6].sin, 0);
  EXPECT_EQ(twelfths[6].cos, -1);
  EXPECT_EQ(twelfths[9].sin, -1);
  EXPECT_EQ(parts_of_a_turn(8)[1].sin, std::sqrt(0.5));  // the root is correctly rounded too
}

TEST(PartsOfATurn, AreSymmetricAndNearExtendedPrecision) {
  constexpr std::uint32_t kParts = 1000;
  const std::vector<SinCos> turn = parts_of_a_turn(kParts);
  for (std::uint32_t k = 1; k < kParts; ++k) {
    ASSERT_EQ(turn[k].sin, -turn[kParts - k].sin) << k;
    ASSERT_EQ(turn[k].cos, turn[kParts - k].cos) << k;
    ASSERT_EQ(turn[k].cos, turn[(k + kParts / 4) % kParts].sin) << k;
    // Half an ulp of a number below 1 is 2^-54; the angle in extended precision is off by less than 2^-61.
    const long double angle = 2 * std::numbers::pi_v<long double> * k / kParts;
    ASSERT_LE(std::abs(turn[k].sin - std::sin(angle)), 0x1p-54L + 0x1p-60L) << k;
  }
}

}  // namespace
}  // namespace plumb
