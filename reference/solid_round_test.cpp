#include "reference/solid_round.h"

#include <gmpxx.h>
#include <gtest/gtest.h>
#include <mpfr.h>

#include <random>

namespace plumb {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kSmallest = std::numeric_limits<double>::denorm_min();

Rounded round_fraction(const mpq_class& x, double guess) {
  return round_exactly(
      guess, [&](int scale, double a, double b) { return sgn(mpq_class(scale * x - (mpq_class(a) + mpq_class(b)))); });
}

/// The same by MPFR, which reads the fraction exactly.
double by_mpfr(const mpq_class& x, mpfr_rnd_t direction) {
  const mpfr_exp_t low = mpfr_get_emin(), high = mpfr_get_emax();
  mpfr_set_emin(-1073);
  mpfr_set_emax(1024);
  mpfr_t y;
  mpfr_init2(y, 53);
  const int inexact = mpfr_set_q(y, x.get_mpq_t(), direction);
  mpfr_subnormalize(y, inexact, direction);
  const double result = mpfr_get_d(y, direction);
  mpfr_clear(y);
  mpfr_set_emin(low);
  mpfr_set_emax(high);
  return result;
}

void expect_rounded(const mpq_class& x, double guess) {
  const Rounded r = round_fraction(x, guess);
  EXPECT_EQ(r.nearest, by_mpfr(x, MPFR_RNDN)) << x;
  EXPECT_EQ(r.enclosure.below, by_mpfr(x, MPFR_RNDD)) << x;
  EXPECT_EQ(r.enclosure.above, by_mpfr(x, MPFR_RNDU)) << x;
  EXPECT_FALSE(r.nearest == 0 && std::signbit(r.nearest));
}

TEST(SolidRound, AgreesWithMpfrWhateverTheGuess) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 300; ++i) {
    mpq_class x(static_cast<double>(random()) - 0x1p63);
    x /= mpq_class(static_cast<double>(random() >> 20) + 1);
    for (int k = static_cast<int>(random() % 40) - 20; k != 0; k -= k > 0 ? 1 : -1) x *= k > 0 ? 0x1p52 : 0x1p-52;
    for (const double guess : {by_mpfr(x, MPFR_RNDN), -by_mpfr(x, MPFR_RNDN), 0.0, 1.0, kInfinity, -kInfinity,
                               std::numeric_limits<double>::quiet_NaN()})
      expect_rounded(x, guess);
  }
}

TEST(SolidRound, TiesGoToEvenAndTheEndsOfTheRangeAreRight) {
  const mpq_class tiny(kSmallest), large(kLargest);
  const mpq_class fractions[] = {0,
                                 1,
                                 mpq_class(1) + mpq_class(0x1p-53),
                                 mpq_class(1) + 3 * mpq_class(0x1p-53),
                                 tiny,
                                 tiny / 2,
                                 tiny / 3,
                                 3 * tiny / 2,
                                 5 * tiny / 2,
                                 large,
                                 large + mpq_class(0x1p969),
                                 large + mpq_class(0x1p970),
                                 large + mpq_class(0x1p971),
                                 large * large};
  for (const mpq_class& x : fractions) {
    expect_rounded(x, 0);
    expect_rounded(-x, 0);
  }
  EXPECT_EQ(round_fraction(large + mpq_class(0x1p970), 0).nearest, kInfinity);
  EXPECT_EQ(round_fraction(3 * tiny / 2, 0).nearest, 2 * kSmallest);
}

TEST(SolidRound, FloatsComeFromTheEnclosure) {
  std::mt19937_64 random(6);
  for (int i = 0; i < 2000; ++i) {
    // At and beside midpoints of floats, among denormal floats too, and at the end of their range.
    const float f = std::ldexp(static_cast<float>(random() >> 40), static_cast<int>(random() % 300) - 175);
    const float g = std::nextafter(f, std::numeric_limits<float>::infinity());
    const double tie = std::isinf(g) ? 0x1.ffffffp127 : (static_cast<double>(f) + static_cast<double>(g)) / 2;
    EXPECT_EQ(nearest_float({tie, tie}), static_cast<float>(tie));
    if (!std::isfinite(f)) continue;
    EXPECT_EQ(nearest_float({tie, next_double(tie)}), g) << std::hexfloat << tie;
    EXPECT_EQ(nearest_float({previous_double(tie), tie}), f) << std::hexfloat << tie;
  }
  EXPECT_EQ(nearest_float({0, kSmallest}), 0);
  EXPECT_EQ(nearest_float({kLargest, kInfinity}), std::numeric_limits<float>::infinity());
  EXPECT_FALSE(std::signbit(nearest_float({-kSmallest, 0})));
}

TEST(SolidRound, GridTakesTheNearestMultiple) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 2000; ++i) {
    // A multiple of 2^-55: a quarter of them on the grid, a quarter ties.
    const std::int64_t n = i < 4 ? (std::int64_t{1} << 55) - i : static_cast<std::int64_t>(random() >> (9 + i % 50));
    const mpq_class x = mpq_class(mpz_class(static_cast<long>(i % 2 == 0 ? n : -n))) * mpq_class(0x1p-55);
    const double k = round_to_grid(i % 3 == 0 ? 0.3 : x.get_d(), [&](double m) { return sgn(mpq_class(x - m)); });
    const mpq_class off = abs(mpq_class(x - mpq_class(k)));
    EXPECT_LE(off, mpq_class(0x1p-53));
    EXPECT_EQ(std::fmod(k * 0x1p52, off == mpq_class(0x1p-53) ? 2 : 1), 0);
  }
}

TEST(SolidRound, BallsDecideOnlyWhatExactSignsConfirm) {
  std::mt19937_64 random(8);
  int points = 0, grid = 0;
  for (int i = 0; i < 20000; ++i) {
    const double hi = std::ldexp(static_cast<double>(random() >> 11), -53 - static_cast<int>(random() % 4));
    const double half = (next_double(hi) - hi) / 2;
    // Up to the tie and near it.
    const double share = i % 2 == 0 ? 1 - std::ldexp(1, -static_cast<int>(random() % 53))
                                    : std::ldexp(static_cast<double>(random() >> 11), -53);
    const auto [sum, rest] = two_sum(i % 4 < 2 ? hi : -hi, half * share * (i % 8 < 4 ? 1 : -1));
    const Ball x{sum, rest, i % 3 == 0 ? 0 : half * std::ldexp(1, -static_cast<int>(random() % 60))};
    for (const int end : {-1, 0, 1}) {
      const mpq_class exact = mpq_class(x.hi) + mpq_class(x.lo) + end * mpq_class(x.radius);
      Rounded rounded;
      if (round_ball(x, rounded)) {
        ++points;
        EXPECT_EQ(rounded.nearest, round_fraction(exact, x.hi).nearest);
        EXPECT_EQ(rounded.enclosure, round_fraction(exact, x.hi).enclosure);
      }
      double multiple = 0;
      if (ball_to_grid(x, multiple)) {
        ++grid;
        EXPECT_EQ(multiple, round_to_grid(x.hi, [&](double m) { return sgn(mpq_class(exact - m)); }))
            << std::hexfloat << x.hi << " " << x.lo << " " << x.radius;
      }
    }
  }
  EXPECT_GT(points, 20000);
  EXPECT_GT(grid, 20000);
}

}  // namespace
}  // namespace plumb
