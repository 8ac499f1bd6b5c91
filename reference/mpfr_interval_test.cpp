#include "reference/mpfr_interval.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "reference/exact_bounds_cases_for_tests.h"
#include "reference/exact_bounds_search.h"

namespace plumb {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kSmallest = std::numeric_limits<double>::denorm_min();

bool holds(const MpfrInterval& a, const mpq_class& x) {
  return mpfr_cmp_q(a.lower().get(), x.get_mpq_t()) <= 0 && mpfr_cmp_q(a.upper().get(), x.get_mpq_t()) >= 0;
}

TEST(MpfrEnclose, KnownFractions) {
  EXPECT_EQ(enclose(0), (Enclosure{0, 0}));
  EXPECT_EQ(enclose(mpq_class(-3, 8)), (Enclosure{-0.375, -0.375}));
  EXPECT_EQ(enclose(mpq_class(1, 3)), (Enclosure{0x1.5555555555555p-2, 0x1.5555555555556p-2}));
  EXPECT_EQ(enclose(mpq_class(kLargest) * 2), (Enclosure{kLargest, kInf}));
  EXPECT_EQ(enclose(mpq_class(kLargest) * -2), (Enclosure{-kInf, -kLargest}));
  EXPECT_EQ(enclose(mpq_class(kSmallest) / 2), (Enclosure{0, kSmallest}));
  const Enclosure below_zero = enclose(mpq_class(kSmallest) / -2);
  EXPECT_EQ(below_zero, (Enclosure{-kSmallest, 0}));
  EXPECT_FALSE(std::signbit(below_zero.above));
}

TEST(MpfrEnclose, NearestRoundsOnceAndTiesToEven) {
  const mpq_class ulp = 0x1p-52, little = mpq_class(0x1p-1000);
  EXPECT_EQ(nearest(1 + ulp / 2), 1);
  EXPECT_EQ(nearest(1 + ulp / 2 + little), 1 + 0x1p-52);
  EXPECT_EQ(nearest(1 + ulp * 3 / 2), 1 + 0x1p-51);
  EXPECT_EQ(nearest(-1 - ulp * 3 / 2 + little), -1 - 0x1p-52);
  EXPECT_EQ(nearest(mpq_class(kSmallest) / 2), 0);
  // Rounded to 53 bits first, this would become a tie between denormals.
  EXPECT_EQ(nearest(mpq_class(kSmallest) * 3 / 2 - mpq_class(kSmallest) * ulp / 8), kSmallest);
  EXPECT_EQ(nearest(mpq_class(kLargest) + mpq_class(0x1p970)), kInf);
  EXPECT_EQ(nearest(mpq_class(kLargest) + mpq_class(0x1p969)), kLargest);
}

TEST(MpfrEnclose, AgreesWithComparisons) {
  PlacedShapeCases cases(1);
  int asked = 0;
  for (int i = 0; i < 4000; ++i, ++asked) {
    const auto power = [&] { return mpq_class(std::ldexp(cases.uniform(1, 2), cases.integer(-520, 500))); };
    mpq_class x = power() * power() / mpq_class(cases.integer(1, 1000));
    if (i % 2) x = -x;
    const double above = smallest_that_holds(x.get_d(), [&](double candidate) { return mpq_class(candidate) >= x; });
    const Enclosure enclosure = enclose(x);
    ASSERT_EQ(enclosure.above, above);
    ASSERT_TRUE(enclosure.exact() ? mpq_class(above) == x : std::nextafter(enclosure.below, kInf) == above);
    const double rounded = nearest(x);
    ASSERT_TRUE(rounded == enclosure.below || rounded == enclosure.above);
    if (std::isinf(above) || std::isinf(enclosure.below)) continue;
    ASSERT_LE(abs(x - mpq_class(rounded)), abs(x - mpq_class(enclosure.below)));
    ASSERT_LE(abs(x - mpq_class(rounded)), abs(x - mpq_class(enclosure.above)));
  }
  EXPECT_EQ(asked, 4000);
}

/// Of few bits, so that every operation rounds.
TEST(MpfrInterval, OperationsHoldTheTrueValue) {
  PlacedShapeCases cases(2);
  int asked = 0;
  for (int i = 0; i < 4000; ++i, ++asked) {
    const mpq_class x = cases.uniform(-4, 4), y = cases.uniform(-4, 4), z = cases.integer(-1, 1);
    const MpfrInterval a(x, 10), b(y, 10), c = MpfrInterval(z, 10) * MpfrInterval(x, 7);
    ASSERT_TRUE(holds(a, x) && holds(c, z * x));
    ASSERT_TRUE(holds(a + b, x + y));
    ASSERT_TRUE(holds(a - b, x - y));
    ASSERT_TRUE(holds(a * b, x * y));
    ASSERT_TRUE(holds(c * b, z * x * y));
    ASSERT_TRUE(holds((a - b) * (a + b), x * x - y * y));
    ASSERT_TRUE(holds(a / b, x / y));
    ASSERT_TRUE(holds(square(a + b), (x + y) * (x + y)));
    ASSERT_TRUE(holds(square(sqrt(square(a))), x * x));
    ASSERT_GE(mpfr_sgn(square(a - a).lower().get()), 0);
  }
  EXPECT_EQ(asked, 4000);
}

TEST(MpfrInterval, DividingByZeroTellsNothing) {
  const MpfrInterval quotient = MpfrInterval(1, 53) / (MpfrInterval::pi(53) - MpfrInterval::pi(53));
  EXPECT_EQ(widest_enclosure(quotient), (Enclosure{-kInf, kInf}));
  EXPECT_TRUE((MpfrInterval() * quotient).is_zero());
}

TEST(MpfrInterval, DecidesOnlyWhatItTells) {
  // pi = 0x1.921fb54442d18469...p+1
  const Enclosure pi{0x1.921fb54442d18p1, 0x1.921fb54442d19p1};
  EXPECT_EQ(decided_enclosure(MpfrInterval::pi(64)), pi);
  EXPECT_EQ(decided_nearest(MpfrInterval::pi(64)), pi.below);
  EXPECT_FALSE(decided_enclosure(MpfrInterval::pi(40)));
  EXPECT_FALSE(decided_nearest(MpfrInterval::pi(40)));
  const Enclosure wide = widest_enclosure(MpfrInterval::pi(40));
  EXPECT_LT(wide.below, pi.below);
  EXPECT_GT(wide.above, pi.above);
  EXPECT_EQ(settled_enclosure(MpfrInterval::pi(40)), wide);
  // A narrow interval around a double is taken for it; one that is not that narrow is not.
  const auto around_one = [](int bits) { return sqrt(square(MpfrInterval::pi(bits))) / MpfrInterval::pi(bits); };
  EXPECT_EQ(settled_enclosure(around_one(256)), (Enclosure{1, 1}));
  EXPECT_EQ(settled_enclosure(around_one(128)), (Enclosure{std::nextafter(1, 0), std::nextafter(1, 2)}));
}

TEST(MpfrNumber, CopiesAndMovesKeepTheirPrecision) {
  MpfrNumber a(100);
  mpfr_set_d(a.get(), 1.5, MPFR_RNDN);
  MpfrNumber b = a, c;
  c = b;
  EXPECT_EQ(c.bits(), 100);
  EXPECT_EQ(mpfr_get_d(c.get(), MPFR_RNDN), 1.5);
  const MpfrNumber d = std::move(b);
  EXPECT_EQ(d.bits(), 100);
  EXPECT_EQ(mpfr_get_d(d.get(), MPFR_RNDN), 1.5);
}

}  // namespace
}  // namespace plumb
