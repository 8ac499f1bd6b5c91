#include "reference/algebraic_t.h"

#include <gtest/gtest.h>

#include <random>

namespace plumb {
namespace {

/// scale (t - r)(t - s), whose roots are known.
AlgebraicT with_roots(const mpq_class& r, const mpq_class& s, const mpq_class& scale, int root) {
  return {scale, -scale * (r + s), scale * r * s, root};
}

AlgebraicT rational(const mpq_class& r, const mpq_class& scale) { return {0, scale, -scale * r, 0}; }

TEST(AlgebraicT, OrdersRationalRoots) {
  std::mt19937_64 random(3);
  const auto small = [&] { return mpq_class(static_cast<long>(random() % 9) - 4, 1 + random() % 2); };
  const auto scale = [&] { return mpq_class(static_cast<long>(random() % 5) * 2 - 5); };
  int equal = 0;
  for (int i = 0; i < 20000; ++i) {
    mpq_class r[4];
    for (mpq_class& one : r) one = small(), one.canonicalize();
    const int root_x = static_cast<int>(random() % 2), root_y = static_cast<int>(random() % 2);
    const mpq_class x = root_x == 0 ? std::min(r[0], r[1]) : std::max(r[0], r[1]);
    const mpq_class y = root_y == 0 ? std::min(r[2], r[3]) : std::max(r[2], r[3]);
    const AlgebraicT a = with_roots(r[0], r[1], scale(), root_x), b = with_roots(r[2], r[3], scale(), root_y);
    const int expected = x < y ? -1 : x > y;
    ASSERT_EQ(compare(a, b), expected) << x << " " << y;
    ASSERT_EQ(compare(b, a), -expected);
    ASSERT_EQ(compare(a, rational(y, scale())), expected);
    ASSERT_EQ(compare(rational(x, scale()), b), expected);
    equal += expected == 0;
  }
  EXPECT_GT(equal, 1000);
}

/// Irrational roots against intervals of 600 bits.
TEST(AlgebraicT, OrdersIrrationalRoots) {
  std::mt19937_64 random(4);
  const auto integer = [&] { return mpq_class(static_cast<long>(random() % 41) - 20); };
  const auto value = [](const AlgebraicT& x) {
    const mpf_class a(x.a, 600), b(x.b, 600), c(x.c, 600);
    const mpf_class discriminant = b * b - 4 * a * c;
    const mpf_class turn = (x.root == 1) == (x.a > 0) ? mpf_class(1, 600) : mpf_class(-1, 600);
    return mpf_class((-b + turn * sqrt(discriminant)) / (2 * a), 600);
  };
  int compared = 0, equal = 0;
  for (int i = 0; i < 30000; ++i) {
    AlgebraicT x{integer(), integer(), integer(), static_cast<int>(random() % 2)};
    AlgebraicT y{integer(), integer(), integer(), static_cast<int>(random() % 2)};
    // The same number by another equation: shifted roots would be a different one.
    if (i % 10 == 0) y = {x.a * -3, x.b * -3, x.c * -3, x.root};
    if (x.a == 0 || y.a == 0 || x.b * x.b < 4 * x.a * x.c || y.b * y.b < 4 * y.a * y.c) continue;
    const mpf_class difference = value(x) - value(y);
    // Roots of integer quadratics with coefficients up to 20 either coincide or differ by far more than 2^-300: their
    // resultant is an integer.
    const int expected = abs(difference) < mpf_class(0x1p-300) ? 0 : sgn(difference);
    ASSERT_EQ(compare(x, y), expected) << x.a << " " << x.b << " " << x.c << " / " << y.a << " " << y.b << " " << y.c;
    ++compared;
    equal += expected == 0;
  }
  EXPECT_GT(compared, 10000);
  EXPECT_GT(equal, 500);
}

TEST(AlgebraicT, TellsNearRootsApart) {
  // sqrt(2) against its truncations.
  const AlgebraicT root{1, 0, -2, 1};
  mpz_class digits = sqrt(mpz_class(2) << 2000);
  mpq_class below(digits, mpz_class(1) << 1000), above(digits + 1, mpz_class(1) << 1000);
  below.canonicalize();
  above.canonicalize();
  EXPECT_EQ(compare(root, rational(below, 1)), 1);
  EXPECT_EQ(compare(root, rational(above, 1)), -1);
  // sqrt(2) + 1 as a root of t^2 - 2t - 1, and sqrt(8) - sqrt(2) would be sqrt(2).
  EXPECT_EQ(compare({1, -2, -1, 1}, {3, -6, -3, 1}), 0);
  EXPECT_EQ(compare({1, 0, -8, 1}, {1, 0, -2, 1}), 1);
}

}  // namespace
}  // namespace plumb
