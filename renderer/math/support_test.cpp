#include "renderer/math/support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace plumb {
namespace {

/// 113 bits.
__extension__ using Quad = __float128;

/// Multiples of 1/16 up to 4: few enough bits that the referee's products are exact.
class Sixteenths {
 public:
  explicit Sixteenths(unsigned seed) : engine_(seed) {}
  double operator()() { return std::uniform_int_distribution<int>(-64, 64)(engine_) / 16.0; }
  double positive() { return std::uniform_int_distribution<int>(1, 64)(engine_) / 16.0; }
  Point3 point() { return {(*this)(), (*this)(), (*this)()}; }
  AffineRow row() { return {(*this)(), (*this)(), (*this)(), (*this)()}; }

 private:
  std::mt19937_64 engine_;
};

Quad mapped(const AffineRow& row, const Point3& p) {
  return Quad(row[0]) * p.x + Quad(row[1]) * p.y + Quad(row[2]) * p.z + row[3];
}

/// Whether x >= center + sqrt(square).
bool reaches(double x, Quad center, Quad square) {
  const Quad distance = x - center;
  return distance >= 0 && distance * distance >= square;
}

void expect_smallest(double x, Quad center, Quad square) {
  EXPECT_TRUE(reaches(x, center, square)) << std::hexfloat << x;
  EXPECT_FALSE(reaches(std::nextafter(x, -INFINITY), center, square)) << std::hexfloat << x;
}

TEST(Support, IsTheSmallestDoubleThatHoldsTheBody) {
  // The referee's square has lost bits below 2^-113 of it, while x - center is a multiple of 2^-58 for |x| >= 2^-5, and
  // its square one of 2^-116 of at most 2^13: near zero it might not decide.
  Sixteenths u(1);
  int cases = 0, balls = 0, discs = 0, exact = 0;
  for (int i = 0; i < 20000; ++i, ++cases) {
    const AffineRow row = u.row();
    const Point3 center = u.point();
    const double radius = u.positive(), shift = u();
    EXPECT_EQ(highest(row, center), static_cast<double>(mapped(row, center))) << "few bits: exactly";

    const double ball = highest(row, RoundBody{.center = center, .radius = radius});
    const Quad squares = Quad(row[0]) * row[0] + Quad(row[1]) * row[1];
    const Quad all_squares = squares + Quad(row[2]) * row[2];
    if (std::fabs(ball) >= 0x1p-5) {
      expect_smallest(ball, mapped(row, center), radius * radius * all_squares);
      ++balls;
    }
    const double disc = highest(row, RoundBody{.center = center, .radius = radius, .dimensions = 2, .shift = shift});
    if (std::fabs(disc) >= 0x1p-5) {
      expect_smallest(disc, mapped(row, {center.x, center.y, center.z + shift}), radius * radius * squares);
      ++discs;
      exact += row[0] == 0 || row[1] == 0;
    }
  }
  EXPECT_EQ(cases, 20000);
  EXPECT_GT(balls, 19000);
  EXPECT_GT(discs, 19000);
  EXPECT_GT(exact, 200) << "roots that are rational";
}

TEST(Support, TapersARadiusExactly) {
  // Radius 1 * |2/3| along x, from 1/3 below: 2/3 - 1/3 by sums of doubles; the two roundings meet.
  const AffineRow along_x{1, 0, 0, 0};
  const RoundBody third{.center = {1, 0, 0}, .radius = 1, .dimensions = 2, .numerator = 2, .denominator = -3};
  EXPECT_EQ(highest(along_x, third), std::nextafter(1 + 2.0 / 3, 2)) << "5/3 rounds to below itself";
  const RoundBody whole{.center = {1, 0, 0}, .radius = 1.5, .dimensions = 2, .numerator = 2, .denominator = 3};
  EXPECT_EQ(highest(along_x, whole), 2);
}

TEST(Support, KeepsItsDigitsWhereCenterAndRadiusCancel) {
  // Turned by 36.87 degrees, a unit ball that rests on the floor: the row's length is not quite 1, and what is left of
  // -1 + |row| is some 2^-54. The referee has 113 - 54 bits of it.
  const AffineRow row{0.6, 0.8, 0, -1};
  const Quad square = Quad(0.6) * 0.6 + Quad(0.8) * 0.8;
  const double up = highest(row, RoundBody{.center = {}, .radius = 1});
  EXPECT_NE(up, 0);
  EXPECT_NEAR(up / static_cast<double>((square - 1) / 2), 1, 0x1p-50);
}

TEST(Support, HoldsBodiesOutsideOfTheExactRange) {
  const RoundBody huge{.center = {1e200, 0, 0}, .radius = 1e190};
  const double up = highest({1e80, 0, 0, 0}, huge);
  EXPECT_GE(up, 1e280 * (1 + 1e-10));
  EXPECT_LE(up, 1e280 * (1 + 1e-10) * (1 + 0x1p-50));
  EXPECT_EQ(highest({1e200, 0, 0, 0}, huge), INFINITY);
  const double tiny = highest({1e-200, 1e-200, 0, 0}, RoundBody{.center = {1, 0, 0}, .radius = 1});
  EXPECT_GE(tiny, 2.414213562e-200);
  EXPECT_LE(tiny, 2.414213563e-200);
  EXPECT_GE(highest({1, 1e-200, 0, 0}, Point3{1, 1, 0}), std::nextafter(1, 2));
}

TEST(Support, ABoxIsMappedToTheSmallestOne) {
  // 0.1 x + 0.2 y at the corner (1, 1) is 0.1 + 0.2 without rounding, which lies between two doubles.
  AffineMatrix m = identity_matrix();
  m[0] = {0.1, 0.2, 0, 0};
  const Bounds3 bounds = Transform(m)(Bounds3{{-1, -1, -1}, {1, 1, 1}});
  EXPECT_EQ(bounds.max.x, 0.1 + 0.2) << "the sum rounds up";
  EXPECT_EQ(bounds.min.x, -(0.1 + 0.2));
  EXPECT_EQ(bounds.max.y, 1);
  EXPECT_TRUE(Transform(m)(Bounds3{}).empty());
}

TEST(Support, TheQuickBoundIsNeverBelow) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> u(-1, 1);
  int cases = 0;
  for (int i = 0; i < 20000; ++i, ++cases) {
    const AffineRow row{u(random), u(random), u(random), u(random)};
    const Point3 p{u(random), u(random), u(random)};
    const double exact = highest(row, p);
    EXPECT_GE(about_highest(row, {p, p}), std::nextafter(exact, -INFINITY));
    EXPECT_LE(about_highest(row, {p, p}), exact + 0x1p-47);
  }
  EXPECT_EQ(cases, 20000);
}

}  // namespace
}  // namespace plumb
