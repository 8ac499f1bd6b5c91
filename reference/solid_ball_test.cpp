#include "reference/solid_ball.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <random>

#include "reference/solid_round.h"

namespace plumb {
namespace {

using Random = std::mt19937_64;

/// 53 random bits (or few, or a power of two) at an exponent of up to +-range.
double number(Random& random, int range) {
  const auto bits = static_cast<double>(random() >> (random() % 3 == 0 ? 60 : 11));
  const int exponent = static_cast<int>(random() % static_cast<unsigned>(2 * range + 1)) - range - 50;
  return std::ldexp(random() % 2 == 0 ? bits : -bits, exponent);
}

Ball ball(Random& random, int range) {
  const double hi = number(random, range);
  if (random() % 4 == 0) return {hi};
  const auto [sum, rest] = two_sum(hi, hi * 0x1p-54 * std::ldexp(static_cast<double>(random() >> 11), -53));
  return {sum, rest, random() % 2 == 0 ? 0 : std::fabs(hi) * std::ldexp(1, -static_cast<int>(random() % 100))};
}

mpq_class middle(const Ball& x) { return mpq_class(x.hi) + mpq_class(x.lo); }
/// A value in the ball: its middle or either end.
mpq_class value(const Ball& x, int which) { return middle(x) + which * mpq_class(x.radius); }

bool usable(const Ball& x) { return std::isfinite(x.hi) && std::isfinite(x.lo) && std::isfinite(x.radius); }
bool holds(const Ball& x, const mpq_class& exact) { return abs(mpq_class(exact - middle(x))) <= mpq_class(x.radius); }
/// hi is the middle, rounded.
bool normal(const Ball& x) { return x.hi + x.lo == x.hi; }

TEST(SolidBall, OperationsEncloseTheExactResult) {
  Random random(11);
  int used = 0, exact = 0;
  for (int i = 0; i < 12000; ++i) {
    // Every third case lies where products and their error terms underflow, every third beyond the largest double.
    const int range = i % 3 == 0 ? 20 : i % 3 == 1 ? 530 : 1000;
    const Ball a = ball(random, range);
    // Half of the sums cancel all but a few bits.
    const Ball b = i % 2 == 0 ? ball(random, range) : Ball(-a.hi, -a.lo * 0.5, a.radius);
    const Ball results[] = {a + b, a - b, a * b, a / b};
    for (int op = 0; op < 4; ++op) {
      const Ball& r = results[op];
      if (!usable(r)) continue;
      EXPECT_TRUE(normal(r));
      for (const int ends : {-1, 0, 1}) {
        const mpq_class x = value(a, ends);
        const mpq_class y = value(b, i % 5 == 0 ? -ends : ends);
        const mpq_class expected = op == 0   ? mpq_class(x + y)
                                   : op == 1 ? mpq_class(x - y)
                                   : op == 2 ? mpq_class(x * y)
                                             : mpq_class(x / y);
        ASSERT_TRUE(holds(r, expected)) << "operation " << op << std::hexfloat << " a " << a.hi << " " << a.lo << " "
                                        << a.radius << " b " << b.hi << " " << b.lo << " " << b.radius;
      }
      ++used;
      exact += r.radius == 0;
    }
  }
  EXPECT_GT(used, 24000);
  EXPECT_GT(exact, 800);
}

TEST(SolidBall, RootsEncloseTheExactResult) {
  Random random(12);
  int used = 0;
  for (int i = 0; i < 6000; ++i) {
    Ball a = ball(random, i % 2 == 0 ? 20 : 1000);
    if (a.hi < 0) a = -a;
    if (sign_or_undecided(a) != 1) continue;
    const Ball r = sqrt(a);
    if (!usable(r)) continue;
    EXPECT_TRUE(normal(r));
    for (const int end : {-1, 0, 1}) {
      // lowest <= sqrt(x) <= highest, all of them >= 0.
      const mpq_class lowest = value(r, -1);
      const mpq_class highest = value(r, 1);
      const mpq_class x = value(a, end);
      EXPECT_TRUE(lowest <= 0 || lowest * lowest <= x);
      EXPECT_TRUE(highest >= 0 && highest * highest >= x);
    }
    ++used;
  }
  EXPECT_GT(used, 3000);
}

TEST(SolidBall, IsTightOnOrdinaryNumbers) {
  // 2^-102 a product, and the quotient's and the root's residual is one product and one sum.
  Random random(13);
  for (int i = 0; i < 2000; ++i) {
    Ball a = ball(random, 20), b = ball(random, 20);
    a.radius = b.radius = 0;
    if (a.hi == 0 || b.hi == 0) continue;
    for (const Ball& r : {a * b, a / b, sqrt(a.hi < 0 ? -a : a)}) EXPECT_LE(r.radius, 0x1p-100 * std::fabs(r.hi));
    EXPECT_LE((a + b).radius, 0x1p-103 * (std::fabs(a.hi) + std::fabs(b.hi)));
  }
}

TEST(SolidBall, WholeNumbersStayExact) {
  const Ball three = Ball(12) * Ball(0.25);
  EXPECT_EQ((three - Ball(3)).hi, 0);
  EXPECT_EQ(sign_or_undecided(three - Ball(3)), 0);
  EXPECT_EQ(sqrt(Ball(25) * Ball(9)).hi, 15);
  EXPECT_EQ(sqrt(Ball(25) * Ball(9)).radius, 0);
  EXPECT_EQ((Ball(15) / Ball(-5)).radius, 0);
}

TEST(SolidBall, OverflowAndDivisionByZeroDecideNothing) {
  const Ball big(0x1p1000);
  EXPECT_EQ(sign_or_undecided(big * big), kUndecided);
  EXPECT_EQ(sign_or_undecided(big * Ball(0x1p24)), kUndecided);
  EXPECT_EQ(sign_or_undecided(Ball(std::numeric_limits<double>::max()) + Ball(std::numeric_limits<double>::max())),
            kUndecided);
  EXPECT_EQ(sign_or_undecided(Ball(1) / Ball()), kUndecided);
  EXPECT_EQ(sign_or_undecided(Ball(1) / Ball(1, 0, 2)), kUndecided);
  EXPECT_EQ(sign_or_undecided(sqrt(Ball(-1))), kUndecided);
  EXPECT_EQ(sign_or_undecided(Ball(0x1p-600) * Ball(0x1p-600)), kUndecided);
}

}  // namespace
}  // namespace plumb
