#include "meshes/validation/product_sum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace plumb {
namespace {

constexpr double kTiny = std::numeric_limits<double>::denorm_min();
constexpr double kMost = std::numeric_limits<double>::max();

TEST(ProductSum, HoldsTheWholeRange) {
  ProductSum sum;
  EXPECT_EQ(sum.sign(), 0);
  sum.add(kTiny, -kTiny, kTiny);
  EXPECT_EQ(sum.sign(), -1);
  sum.add(kMost, kMost, kMost);
  EXPECT_EQ(sum.sign(), 1);
  sum.subtract(kMost, kMost, kMost);
  EXPECT_EQ(sum.sign(), -1);
  sum.subtract(-kTiny, -kTiny, -kTiny);
  EXPECT_EQ(sum.sign(), 0);
  sum.add(0, kMost, kMost);
  sum.add(kMost, -0.0);
  EXPECT_EQ(sum.sign(), 0);
}

/// Numbers of any size, whose products are taken off again in another order and with factors regrouped by powers of
/// two. What is left is what was added last.
TEST(ProductSum, WhatIsAddedCanBeTakenOff) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> significand(-2, 2);
  std::uniform_int_distribution<int> exponent(-1000, 1000);
  const auto number = [&] { return std::ldexp(significand(random), exponent(random)); };
  int sums = 0;
  for (; sums < 200; ++sums) {
    ProductSum sum;
    double terms[20][3];
    for (auto& [a, b, c] : terms) {
      a = number(), b = number(), c = number();
      sum.add(a, b, c);
    }
    const double last = sums % 2 == 0 ? kTiny : -kTiny;
    sum.add(last, kTiny, kTiny);
    for (int i = 19; i >= 0; --i) {
      const auto& [a, b, c] = terms[i];
      sum.subtract(c, 4 * a, b / 4);
    }
    EXPECT_EQ(sum.sign(), last > 0 ? 1 : -1);
  }
  EXPECT_EQ(sums, 200);
}

/// Sums of a few products of small whole numbers, with the sign that whole-number arithmetic gives.
TEST(ProductSum, AgreesWithWholeNumbers) {
  std::mt19937_64 random(2);
  std::uniform_int_distribution<std::int64_t> whole(-3, 3);
  int signs[3] = {};
  for (int i = 0; i < 20000; ++i) {
    ProductSum sum;
    std::int64_t expected = 0;
    for (int term = 0; term < 4; ++term) {
      const std::int64_t a = whole(random), b = whole(random), c = whole(random);
      sum.add(static_cast<double>(a), static_cast<double>(b), static_cast<double>(c));
      expected += a * b * c;
    }
    ASSERT_EQ(sum.sign(), (expected > 0) - (expected < 0));
    ++signs[sum.sign() + 1];
  }
  EXPECT_GT(signs[0], 8000);
  EXPECT_GT(signs[1], 300);
  EXPECT_GT(signs[2], 8000);
}

}  // namespace
}  // namespace plumb
