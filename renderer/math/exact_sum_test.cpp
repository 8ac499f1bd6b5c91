#include "renderer/math/exact_sum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace plumb {
namespace {

TEST(ExactSum, LosesNothingInAnyOrder) {
  // Some thousand doubles with exponents from -200 to 200, taken out again in another order, leave nothing.
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> u(-1, 1);
  std::uniform_int_distribution<int> exponent(-200, 200);
  int sums = 0;
  for (int round = 0; round < 20; ++round, ++sums) {
    std::vector<double> terms;
    for (int i = 0; i < 1000; ++i) terms.push_back(std::ldexp(u(random), exponent(random)));
    ExactSum sum;
    for (const double term : terms) sum.add(term);
    std::shuffle(terms.begin(), terms.end(), random);
    const double last = terms.back();
    terms.pop_back();
    for (const double term : terms) sum.add(-term);
    EXPECT_EQ(static_cast<double>(sum.rounded()), last);
    EXPECT_EQ(sum.add(-last).sign(), 0);
  }
  EXPECT_EQ(sums, 20);
}

TEST(ExactSum, HoldsMoreTermsThanParts) {
  // A hundred single bits, 20 apart: only packed together they find room.
  ExactSum sum;
  for (int i = -50; i < 50; ++i) sum.add(std::ldexp(1, 20 * i));
  EXPECT_EQ(sum.sign(), 1);
  for (int i = 49; i > -50; --i) sum.add(-std::ldexp(1, 20 * i));
  EXPECT_EQ(static_cast<double>(sum.rounded()), 0x1p-1000);
}

TEST(ExactSum, ProductsObeyTheBinomialTheorem) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> u(-1, 1);
  int cases = 0;
  for (int i = 0; i < 2000; ++i, ++cases) {
    const ExactSum a = ExactSum(u(random)).add(0x1p-40 * u(random)).add_product(u(random), u(random));
    const ExactSum b = ExactSum(u(random)).add(0x1p60 * u(random));
    EXPECT_EQ(((a + b) * (a - b) - (a * a - b * b)).sign(), 0) << i;
    EXPECT_EQ(((a + b) * (a + b) - a * a - b * b - 2 * a * b).sign(), 0) << i;
    EXPECT_NEAR(static_cast<double>(((a + b) * (a + b)).rounded() / ((a + b).rounded() * (a + b).rounded())), 1, 1e-15);
  }
  EXPECT_EQ(cases, 2000);
}

TEST(ExactSum, SignIsThatOfWhatCancellationLeaves) {
  EXPECT_EQ(ExactSum(1e200).add(-1e-200).add(-1e200).sign(), -1);
  EXPECT_EQ(static_cast<double>(ExactSum(1e200).add(-1e-200).add(-1e200).rounded()), -1e-200);
  EXPECT_EQ(ExactSum().sign(), 0);
  EXPECT_EQ(ExactSum(0.1).add_product(-0.1, 1).sign(), 0);
}

TEST(ExactSum, RoundsToTheDoublesAroundIt) {
  const double above = std::nextafter(1, 2), below = std::nextafter(1, 0);
  EXPECT_EQ(rounded_up(ExactSum(1)), 1);
  EXPECT_EQ(rounded_down(ExactSum(1)), 1);
  EXPECT_EQ(rounded_up(ExactSum(1).add(0x1p-300)), above);
  EXPECT_EQ(rounded_down(ExactSum(1).add(0x1p-300)), 1);
  EXPECT_EQ(rounded_up(ExactSum(1).add(-0x1p-300)), 1);
  EXPECT_EQ(rounded_down(ExactSum(1).add(-0x1p-300)), below);
  EXPECT_FALSE(std::signbit(rounded_down(ExactSum())));
}

TEST(SumWithRoot, RoundsUp) {
  const auto up = [](const ExactSum& center, const ExactSum& numerator, const ExactSum& denominator,
                     const ExactSum& radicand) {
    return rounded_up(SumWithRoot{center, numerator, denominator, radicand});
  };
  EXPECT_EQ(up(1, 3, 1, 25), 16);
  EXPECT_EQ(up(1, -3, 2, 25), 8.5) << "the quotient counts by its size";
  EXPECT_EQ(up(1, 1, 3, 9), 2) << "1/3 is no double, the sum is one";
  EXPECT_EQ(up(-5, 1, 1, 25), 0);
  EXPECT_EQ(up(2, 0, 1, 7), 2);
  // sqrt(25 + e) = 5 + e/10: a double below or above.
  EXPECT_EQ(up(0, 1, 1, ExactSum(25).add(0x1p-200)), std::nextafter(5, 6));
  EXPECT_EQ(up(0, 1, 1, ExactSum(25).add(-0x1p-200)), 5);
  // What is left of a cancellation keeps all its digits: e/10, rounded up.
  EXPECT_EQ(up(-5, 1, 1, ExactSum(25).add(0x1p-200)), 0x1p-200 / 10);  // 1/10 rounds up as a double
  // sqrt(2) lies between these two; the lower one is nearer.
  EXPECT_EQ(up(0, 1, 1, 2), 0x1.6a09e667f3bcdp0);
  EXPECT_EQ(-up(0, 1, 1, 2), std::nextafter(-0x1.6a09e667f3bccp0, -2));
}

}  // namespace
}  // namespace plumb
