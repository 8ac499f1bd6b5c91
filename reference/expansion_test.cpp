#include "reference/expansion.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <random>

namespace plumb {
namespace {

class Doubles {
 public:
  /// Zero now and then, short and long mantissas, exponents over the whole stated range.
  double next() {
    const int kind = static_cast<int>(random_() % 8);
    if (kind == 0) return 0;
    const double mantissa =
        kind < 4 ? static_cast<double>(random_() % 15 + 1) : std::ldexp(double(random_() >> 11), -52);
    const int exponent = static_cast<int>(random_() % 391) - 195;
    const double x = std::ldexp(mantissa, kind % 2 == 0 ? exponent : exponent / 16);
    return in_expansion_range(x) ? (random_() % 2 == 0 ? x : -x) : 1;
  }

 private:
  std::mt19937_64 random_{5};
};

template <int kCapacity>
mpq_class value(const Expansion<kCapacity>& e) {
  mpq_class sum = 0;
  for (int i = 0; i < e.size(); ++i) sum += mpq_class(e[i]);
  return sum;
}

/// The parts must grow, be free of zeros and not overlap: each is less than the last bit of the next.
template <int kCapacity>
void expect_well_formed(const Expansion<kCapacity>& e) {
  for (int i = 0; i < e.size(); ++i) {
    EXPECT_NE(e[i], 0);
    if (i == 0) continue;
    const mpq_class next(e[i]);
    int exponent = 0;
    std::frexp(e[i], &exponent);
    double last_bit = std::ldexp(1, exponent - 53);
    while (std::fmod(e[i], 2 * last_bit) == 0) last_bit *= 2;
    EXPECT_LT(std::abs(e[i - 1]), last_bit);
  }
}

template <int kCapacity>
void expect_is(const Expansion<kCapacity>& e, const mpq_class& expected) {
  EXPECT_EQ(value(e), expected);
  EXPECT_EQ(e.sign(), sgn(expected));
  expect_well_formed(e);
}

TEST(Expansion, SumsAndProductsAreExactUpToDegreeFour) {
  Doubles doubles;
  int long_ones = 0;
  for (int i = 0; i < 3000; ++i) {
    double x[12];
    for (double& one : x) one = doubles.next();
    mpq_class q[12];
    for (int k = 0; k < 12; ++k) q[k] = x[k];
    const auto a = exact_difference(x[0], x[1]), b = exact_difference(x[2], x[3]), c = exact_difference(x[4], x[5]);
    const mpq_class qa = q[0] - q[1], qb = q[2] - q[3], qc = q[4] - q[5];
    expect_is(a, qa);
    const auto minor = a * b - c * x[6];
    const mpq_class q_minor = qa * qb - qc * q[6];
    expect_is(minor, q_minor);
    const auto cubic = minor * c + minor * x[7];
    const mpq_class q_cubic = q_minor * (qc + q[7]);
    expect_is(cubic, q_cubic);
    const auto quartic = cubic * x[8] - minor * a * x[9];
    expect_is(quartic, q_cubic * q[8] - q_minor * qa * q[9]);
    expect_is(quartic - quartic, 0);
    long_ones += quartic.size() > 8;
    ASSERT_FALSE(HasFailure()) << i;
  }
  EXPECT_GT(long_ones, 1000);
}

TEST(Expansion, TheRangeHoldsZeroAndItsEnds) {
  for (const double x : {0.0, -0.0, kExpansionMin, -kExpansionMin, kExpansionMax, 1.0})
    EXPECT_TRUE(in_expansion_range(x));
  for (const double x : {kExpansionMin / 2, kExpansionMax * 2, -1e300, std::nan(""), HUGE_VAL, 0x1p-1074})
    EXPECT_FALSE(in_expansion_range(x));
}

TEST(Expansion, IsExactAtTheEndsOfTheRange) {
  // Smallest last bits: the quartic's parts reach 2^-1008.
  const double small = kExpansionMin * (1 + 0x1p-52), large = kExpansionMax * (1 - 0x1p-53);
  for (const double x : {small, large}) {
    const mpq_class q(x);
    const auto square = exact_difference(x, -x) * exact_difference(x, 3 * x / 4);
    expect_is(square * x * x, (q + q) * (q - mpq_class(3 * x / 4)) * q * q);
  }
}

}  // namespace
}  // namespace plumb
