#include "reference/exact_bounds_filter_number.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "reference/exact_bounds_cases_for_tests.h"

namespace plumb {
namespace {

bool is_known(const FilterNumber& a) {
  return std::isfinite(a.approximation()) && std::isfinite(a.correction()) && std::isfinite(a.error());
}

mpq_class sum_of(const FilterNumber& a) { return mpq_class(a.approximation()) + mpq_class(a.correction()); }

/// A number of the filter beside its true value.
struct Tracked {
  FilterNumber number;
  mpq_class truth;
};

Tracked operator+(const Tracked& a, const Tracked& b) { return {a.number + b.number, a.truth + b.truth}; }
Tracked operator-(const Tracked& a, const Tracked& b) { return {a.number - b.number, a.truth - b.truth}; }
Tracked operator*(const Tracked& a, const Tracked& b) { return {a.number * b.number, a.truth * b.truth}; }
Tracked operator/(const Tracked& a, const Tracked& b) { return {a.number / b.number, a.truth / b.truth}; }
Tracked max(const Tracked& a, const Tracked& b) { return {max(a.number, b.number), std::max(a.truth, b.truth)}; }

/// Counts what was checked, and how near the errors came to their bounds.
struct Tally {
  int known = 0, rounded = 0;
  double worst = 0;

  void check(const Tracked& a) {
    if (!is_known(a.number)) return;
    ++known;
    const mpq_class error = abs(a.truth - sum_of(a.number)), bound = a.number.error();
    ASSERT_LE(error, bound) << std::hexfloat << a.number.approximation();
    if (bound > 0) worst = std::max(worst, mpq_class(error / bound).get_d());
    const auto up = a.number.round_up();
    if (!up) return;
    ++rounded;
    ASSERT_GE(mpq_class(*up), a.truth);
    ASSERT_LT(mpq_class(std::nextafter(*up, -std::numeric_limits<double>::infinity())), a.truth);
  }
};

TEST(FilterNumber, BoundsHoldInChainsOfOperations) {
  PlacedShapeCases cases(1);
  Tally tally;
  for (int i = 0; i < 4000; ++i) {
    // Mild, then mixed exponents, then ones that under- and overflow.
    const int spread = i % 3 == 0 ? 3 : i % 3 == 1 ? 60 : 500;
    const auto number = [&] {
      const double x = i % 5 ? std::ldexp(cases.uniform(-1, 1), cases.integer(-spread, spread)) : cases.integer(-9, 9);
      return Tracked{x, x};
    };
    const Tracked a = number(), b = number(), c = number(), d = number();
    const Tracked sum = a * b + c * d, cancelled = sum - a * b, third = sum * c;
    for (const Tracked& x : {a + b, a * b, sum, cancelled, third, max(sum, cancelled), third * cancelled - sum})
      ASSERT_NO_FATAL_FAILURE(tally.check(x)) << i;
    if (b.truth == 0 || sum.truth == 0) continue;
    for (const Tracked& x : {a / b, third / b, a / sum, cancelled / sum}) ASSERT_NO_FATAL_FAILURE(tally.check(x)) << i;
  }
  EXPECT_GT(tally.known, 30000);
  EXPECT_GT(tally.rounded, 27000);
  // Errors of measured losses come up to their bounds, never beyond.
  EXPECT_LE(tally.worst, 1);
  EXPECT_GT(tally.worst, 0.1);
}

TEST(FilterNumber, RootsAreWithinTheirBounds) {
  PlacedShapeCases cases(2);
  int known = 0;
  for (int i = 0; i < 4000; ++i) {
    const double x = std::ldexp(cases.uniform(0.5, 1), cases.integer(-400, 400)), y = cases.uniform(0, 1) * x;
    const Tracked squares{FilterNumber(x) * x + FilterNumber(y) * y, mpq_class(x) * x + mpq_class(y) * y};
    const FilterNumber root = sqrt(squares.number);
    if (!is_known(root)) continue;
    ++known;
    const mpq_class middle = sum_of(root), error = root.error();
    ASSERT_LE((middle - error) * (middle - error), squares.truth) << std::hexfloat << x << " " << y;
    ASSERT_GE((middle + error) * (middle + error), squares.truth) << std::hexfloat << x << " " << y;
    ASSERT_LT(error, middle * mpq_class(0x1p-95)) << std::hexfloat << x << " " << y;
  }
  EXPECT_EQ(known, 4000);
}

TEST(FilterNumber, ExactResultsStayKnownAsExact) {
  const FilterNumber three(3), four(4), third = FilterNumber(1) / three;
  EXPECT_TRUE(sqrt(three * three + four * four).exact());
  EXPECT_EQ(sqrt(three * three + four * four).round_up(), 5);
  EXPECT_TRUE((FilterNumber(12) / four).exact());
  EXPECT_TRUE((FilterNumber(1) + FilterNumber(0x1p-60)).exact());
  EXPECT_EQ((FilterNumber(1) + FilterNumber(0x1p-60)).round_up(), 1 + 0x1p-52);
  EXPECT_EQ((FilterNumber(1) - FilterNumber(0x1p-60)).round_up(), 1);
  EXPECT_FALSE(third.exact());
  EXPECT_EQ(third.round_up(), 0x1.5555555555556p-2);
  // What may be a double or not is not decided.
  EXPECT_EQ((third + third + third).round_up(), std::nullopt);
}

TEST(FilterNumber, WhatLeavesTheRangeIsUndecided) {
  const FilterNumber huge(1e300), tiny(1e-300);
  EXPECT_EQ((huge * huge).round_up(), std::nullopt);
  EXPECT_EQ((huge * huge - huge * huge).round_up(), std::nullopt);
  EXPECT_EQ((tiny * tiny).round_up(), std::nullopt);
  EXPECT_EQ(sqrt(tiny).round_up(), std::nullopt);
  EXPECT_EQ((FilterNumber(1) / tiny).round_up(), std::nullopt);
  EXPECT_EQ(max(FilterNumber(1), huge * huge).round_up(), std::nullopt);
  EXPECT_EQ(max(huge * huge, FilterNumber(1)).round_up(), std::nullopt);
  EXPECT_EQ((FilterNumber(1) / FilterNumber(0)).round_up(), std::nullopt);
  EXPECT_EQ(sqrt(FilterNumber(-1)).round_up(), std::nullopt);
  EXPECT_EQ((FilterNumber(0) * huge).round_up(), 0);
  // A remainder whose quotient underflows is still a remainder.
  const FilterNumber slightly_more = FilterNumber(0x1p1000) + FilterNumber(0x1p-890);
  EXPECT_TRUE(slightly_more.exact());
  EXPECT_EQ(sqrt(slightly_more).round_up(), std::nullopt);
  EXPECT_EQ((slightly_more / FilterNumber(0x1p990)).round_up(), std::nullopt);
}

}  // namespace
}  // namespace plumb
