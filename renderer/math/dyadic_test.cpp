#include "renderer/math/dyadic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace plumb {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kSmallest = std::numeric_limits<double>::denorm_min();

TEST(Dyadic, HoldsEveryDouble) {
  int checked = 0;
  for (const double value : {0.0, -0.0, 1.0, -1.5, 0.1, 0x1p63, 0x1p64, 0x1.fffffffffffffp-1, kLargest, -kLargest,
                             kSmallest, -3 * kSmallest, 0x1p-1022, 0x1.123456789abcdp-1000}) {
    EXPECT_EQ(static_cast<double>(Dyadic(value).rounded()), value) << std::hexfloat << value;
    EXPECT_EQ(Dyadic(value).sign(), value > 0 ? 1 : value < 0 ? -1 : 0);
    ++checked;
  }
  EXPECT_EQ(checked, 14);
}

TEST(Dyadic, KeepsWhatDoublesLose) {
  const Dyadic sum = Dyadic(1) + 0x1p-1074 - 1;
  EXPECT_EQ(static_cast<double>(sum.rounded()), 0x1p-1074);
  EXPECT_EQ((Dyadic(kLargest) + kSmallest - kLargest - kSmallest).sign(), 0);
  EXPECT_EQ((Dyadic(0.1) * 10 - 1).sign(), 1) << "0.1 is the double above a tenth";
}

TEST(Dyadic, AgreesWithWholeNumbersOfTwoDigits) {
  __extension__ using Wide = __int128;
  std::mt19937_64 random(5);
  int compared = 0, negative = 0, cancelled = 0;
  for (int i = 0; i < 100000; ++i) {
    const auto whole = [&] { return static_cast<std::int64_t>(random()) >> (12 + random() % 50); };
    const std::int64_t a = whole(), b = whole(), c = whole(), d = i % 3 ? whole() : b;
    const Wide expected = static_cast<Wide>(a) * b - static_cast<Wide>(i % 3 ? c : a) * d;
    const auto exact = [](std::int64_t x) { return Dyadic(static_cast<double>(x)); };
    const Dyadic found = exact(a) * exact(b) - exact(i % 3 ? c : a) * exact(d);
    ASSERT_EQ(found.sign(), expected > 0 ? 1 : expected < 0 ? -1 : 0) << i;
    // Two doubles hold 106 bits.
    const double high = static_cast<double>(expected), low = static_cast<double>(expected - static_cast<Wide>(high));
    ASSERT_EQ((found - high - low).sign(), 0) << i;
    negative += expected < 0;
    cancelled += expected == 0;
    ++compared;
  }
  EXPECT_EQ(compared, 100000);
  EXPECT_GT(negative, 30000);
  EXPECT_GT(cancelled, 30000);
}

TEST(Dyadic, HoldsTheEleventhPowerOfAnyDouble) {
  for (const double value : {kLargest, kSmallest, -kLargest}) {
    Dyadic power = 1, other = 1;
    for (int i = 0; i < 11; ++i) {
      power = power * (Dyadic(value) + kSmallest);
      other = (Dyadic(value) + kSmallest) * other;
    }
    EXPECT_EQ(power.sign(), value > 0 ? 1 : -1);
    EXPECT_EQ((power - other).sign(), 0);
  }
}

TEST(Dyadic, RoundsToSixtyTwoBits) {
  // x (x + 2^-52) between 1 and 4, against its two doubles' sum in 64 bits.
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> u(1, 2);
  int compared = 0;
  for (int i = 0; i < 10000; ++i, ++compared) {
    const double a = u(random), b = u(random) * (i % 2 ? 0x1p-300 : 1);
    const double high = a * b, low = std::fma(a, b, -high);
    const long double expected = static_cast<long double>(high) + low;
    EXPECT_LE(std::fabs((Dyadic(a) * b).rounded() - expected), 0x1p-62L * expected);
  }
  EXPECT_EQ(compared, 10000);
}

}  // namespace
}  // namespace plumb
