#include "renderer/math/affine_product.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "renderer/math/rotation.h"

namespace plumb {
namespace {

/// 113 bits, the referee of what is claimed in units of 2^-53.
__extension__ using Quad = __float128;
using QuadMatrix = std::array<std::array<Quad, 4>, 3>;

QuadMatrix product(const QuadMatrix& a, const QuadMatrix& b) {
  QuadMatrix result{};
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 4; ++c) {
      for (std::size_t k = 0; k < 3; ++k) result[r][c] += a[r][k] * b[k][c];
      if (c == 3) result[r][c] += a[r][3];
    }
  }
  return result;
}

QuadMatrix quad(const AffineMatrix& m) {
  QuadMatrix result{};
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 4; ++c) result[r][c] = m[r][c];
  return result;
}

QuadMatrix turn(std::size_t axis, double degrees) {
  const auto [cos, sin] = precise_cos_sin_degrees(degrees);
  QuadMatrix m = quad(identity_matrix());
  const std::size_t next = (axis + 1) % 3, after = (axis + 2) % 3;
  m[next][next] = m[after][after] = static_cast<Quad>(cos.high) + cos.low;
  m[after][next] = static_cast<Quad>(sin.high) + sin.low;
  m[next][after] = -m[after][next];
  return m;
}

/// In units of the last place of the exact value.
double units(double value, Quad exact) {
  const double size = std::fabs(static_cast<double>(exact));
  return std::fabs(static_cast<double>(value - exact)) / (std::nextafter(size, INFINITY) - size);
}

TEST(Rotation, PreciseValuesHaveTwiceTheDigits) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> u(-1, 1);
  int cases = 0;
  for (int i = 0; i < 1000; ++i, ++cases) {
    const double angle = 360 * u(random);
    const auto [cos, sin] = precise_cos_sin_degrees(angle);
    EXPECT_EQ(cos.high, cos_sin_degrees(angle).cos);
    EXPECT_EQ(sin.high, cos_sin_degrees(angle).sin);
    // Each is off by at most 2^-106, and so the sum of the squares by less than four times that, beside its roundings.
    const Quad c = static_cast<Quad>(cos.high) + cos.low, s = static_cast<Quad>(sin.high) + sin.low;
    EXPECT_LE(std::fabs(static_cast<double>(c * c + s * s - 1)), 0x1p-103) << angle;
  }
  EXPECT_EQ(cases, 1000);
  EXPECT_EQ(precise_cos_sin_degrees(60).cos.low, 0);
  EXPECT_EQ(precise_cos_sin_degrees(90).cos.high, 0);
}

TEST(AffineProduct, RoundsOnceHoweverManyFactorsThereAre) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> u(-1, 1);
  double worst = 0, worst_plain = 0;
  int entries = 0;
  for (int i = 0; i < 1000; ++i) {
    AffineProduct precise;
    QuadMatrix exact = quad(identity_matrix());
    AffineMatrix plain = identity_matrix();
    for (int depth = 0; depth <= i % 8; ++depth) {
      const Vec3 offset{u(random), u(random), u(random)};
      const Vec3 angles{180 * u(random), 180 * u(random), 180 * u(random)};
      const Vec3 factors{std::exp(u(random)), -std::exp(u(random)), std::exp(u(random))};
      precise.translate(offset).rotate_degrees(angles).scale(factors);
      exact = product(exact, quad(translation(offset)));
      for (const std::size_t axis : {2U, 1U, 0U}) exact = product(exact, turn(axis, angles[static_cast<int>(axis)]));
      exact = product(exact, quad(scaling(factors)));
      plain = plain * translation(offset) * rotation_degrees(angles) * scaling(factors);
    }
    const AffineMatrix rounded = precise.rounded();
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 4; ++c, ++entries) {
        // Entries are of size 1 to 20000, and the referee is off by some 2^-100 of that: below a hundredth of a unit
        // for entries that cancel down to 2^-40.
        if (std::fabs(rounded[r][c]) < 0x1p-30) continue;
        worst = std::max(worst, units(rounded[r][c], exact[r][c]));
        worst_plain = std::max(worst_plain, units(plain[r][c], exact[r][c]));
      }
    }
  }
  EXPECT_LE(worst, 0.51);
  EXPECT_GT(worst_plain, 100) << "plain products would not do";
  EXPECT_EQ(entries, 12000);
}

TEST(AffineProduct, FactorsAreAppliedFromTheRight) {
  // The scale first, then the quarter turn about z, then the offset: (1,0,0) -> (2,0,0) -> (0,2,0) -> (0,2,5).
  const Transform t(AffineProduct().translate({0, 0, 5}).rotate_degrees({0, 0, 90}).scale({2, 1, 1}).rounded());
  EXPECT_EQ(t(Point3{1, 0, 0}), (Point3{0, 2, 5}));
  EXPECT_EQ(AffineProduct().rotate_degrees({90, 90, 90}).rounded(), rotation_degrees({90, 90, 90}));
}

TEST(AffineProduct, OverflowAndNaNStayVisible) {
  EXPECT_THROW(Transform(AffineProduct().scale({1e200, 1, 1}).scale({1e200, 1, 1}).rounded()), SingularTransform);
  EXPECT_THROW(Transform(AffineProduct().scale({NAN, 1, 1}).rounded()), SingularTransform);
  EXPECT_THROW(Transform(AffineProduct().rotate_degrees({INFINITY, 0, 0}).rounded()), SingularTransform);
}

}  // namespace
}  // namespace plumb
