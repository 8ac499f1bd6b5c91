#include "renderer/math/transform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "renderer/math/rotation.h"

namespace plumb {
namespace {

TEST(Rotation, IsExactAtRightAngles) {
  EXPECT_EQ(cos_sin_degrees(90).cos, 0);
  EXPECT_EQ(cos_sin_degrees(90).sin, 1);
  EXPECT_EQ(cos_sin_degrees(180).sin, 0);
  EXPECT_EQ(cos_sin_degrees(-270).sin, 1);
  EXPECT_EQ(cos_sin_degrees(60).cos, 0.5);
  EXPECT_TRUE(std::isnan(cos_sin_degrees(INFINITY).cos));
}

TEST(Rotation, AppliesXFirstAndZLast) {
  // x: (0,1,0) -> (0,0,1); y: -> (1,0,0); z: -> (0,1,0).
  const Transform r(rotation_degrees({90, 90, 90}));
  EXPECT_EQ(r(Vec3{0, 1, 0}), (Vec3{0, 1, 0}));
  // x leaves (1,0,0); y: -> (0,0,-1); z leaves it. The reverse order would give (0,1,0)-like results.
  EXPECT_EQ(r(Vec3{1, 0, 0}), (Vec3{0, 0, -1}));
}

TEST(Transform, NormalsTakeTheInverseTranspose) {
  // M2 of the catalogue: diag(2,1,1) turns the plane x + y = 0 so that its normal is (1/2, 1, 0).
  const Transform t(scaling({2, 1, 1}));
  EXPECT_EQ(t(Normal3{1, 1, 0}), (Normal3{0.5, 1, 0}));
}

TEST(Transform, SingularOnesThrow) {
  EXPECT_THROW(Transform(scaling({1, 0, 1})), SingularTransform);
  EXPECT_THROW(Transform(rotation_degrees({10, 20, 30}) * scaling({1, 1, 0})), SingularTransform);
  EXPECT_THROW(Transform(scaling({NAN, 1, 1})), SingularTransform);
  EXPECT_THROW(Transform(scaling({1e-320, 1, 1})), SingularTransform);  // its inverse overflows
}

TEST(Transform, InverseUndoesRandomMaps) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> u(-1, 1);
  int cases = 0;
  for (int i = 0; i < 2000; ++i) {
    const AffineMatrix m = translation({u(random), u(random), u(random)}) *
                           rotation_degrees({180 * u(random), 180 * u(random), 180 * u(random)}) *
                           scaling({1.5 + u(random), 1.5 + u(random), 1.5 + u(random)});
    const Transform world_from_object(m);
    const Point3 p{u(random), u(random), u(random)};
    const Point3 back = world_from_object.inverse()(world_from_object(p));
    // Two matrix applications of three products each, on entries at most 2.5 / 0.5 in ratio: the error
    // stays below 2 * 8 u * |M^-1| |M| |p| with u = 2^-53, |M| |M^-1| <= 3.5 * 2 * 3.
    EXPECT_LE(length(back - p), 16 * 0x1p-53 * 21 * 4);
    ++cases;
  }
  EXPECT_EQ(cases, 2000);
}

/// 113 bits.
__extension__ using Quad = __float128;

TEST(Transform, InverseIsRightToTheLastPlaceAtAnyCondition) {
  // The referee inverts by cofactors in 113 bits. At condition 1e12 its determinant loses 40 of them, and a cofactor of
  // a few of its inputs' 53 as many: 2^-70 is left, far below a hundredth of 2^-53.
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> u(-1, 1);
  double worst = 0;
  int entries = 0, ill_conditioned = 0;
  for (int i = 0; i < 2000; ++i) {
    AffineMatrix m = identity_matrix();
    const int depth = 1 + i % 4;
    for (int k = 0; k < depth; ++k) {
      const auto factor = [&] { return std::pow(10, 6.0 / depth * u(random)); };
      m = m * translation({u(random), u(random), u(random)}) *
          rotation_degrees({180 * u(random), 180 * u(random), 180 * u(random)}) *
          scaling({factor(), factor(), factor()});
    }
    const AffineMatrix inverse = Transform(m).inverse_matrix();
    const auto e = [&](std::size_t r, std::size_t c) { return static_cast<Quad>(m[r % 3][c % 3]); };
    const auto cofactor = [&](std::size_t r, std::size_t c) {
      return e(r + 1, c + 1) * e(r + 2, c + 2) - e(r + 1, c + 2) * e(r + 2, c + 1);
    };
    const Quad det = e(0, 0) * cofactor(0, 0) + e(0, 1) * cofactor(0, 1) + e(0, 2) * cofactor(0, 2);
    const auto check = [&](double value, Quad exact) {
      const double size = std::fabs(static_cast<double>(exact));
      const double units = std::fabs(static_cast<double>(value - exact)) / (std::nextafter(size, INFINITY) - size);
      worst = std::max(worst, units);
      ++entries;
    };
    double largest = 0, largest_inverse = 0;
    for (std::size_t r = 0; r < 3; ++r) {
      Quad offset = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        check(inverse[r][c], cofactor(c, r) / det);
        offset -= cofactor(c, r) * m[c][3] / det;
        largest = std::max(largest, std::fabs(m[r][c]));
        largest_inverse = std::max(largest_inverse, std::fabs(inverse[r][c]));
      }
      check(inverse[r][3], offset);
    }
    ill_conditioned += largest * largest_inverse > 1e8;
  }
  EXPECT_LE(worst, 0.51);
  EXPECT_EQ(entries, 24000);
  EXPECT_GT(ill_conditioned, 150);
}

TEST(Transform, InverseNeitherOverflowsNorUnderflowsOnItsWay) {
  // The determinants are 1e-600, 1e600 and 1: only the first two would leave the range of doubles.
  for (const Vec3& factors : {Vec3{1e-200, 1e-200, 1e-200}, Vec3{1e200, 1e200, 1e200}, Vec3{1e-290, 1, 1e290}}) {
    const AffineMatrix inverse = Transform(scaling(factors)).inverse_matrix();
    for (int i = 0; i < 3; ++i)
      EXPECT_EQ(inverse[static_cast<std::size_t>(i)][static_cast<std::size_t>(i)], 1 / factors[i]);
    EXPECT_EQ(inverse[0][1], 0);
  }
  EXPECT_EQ(Transform(translation({1e300, -1e-300, 0})).inverse_matrix(), translation({-1e300, 1e-300, 0}));
}

TEST(Transform, SingularityIsDecidedExactly) {
  // The third row is three times the first, 0.1 without its lowest bits so that this is exact. With one of them changed
  // by a unit of the last place there is an inverse.
  const double tenth = 0x1.99999999p-4;
  AffineMatrix m{{{tenth, 0.7, tenth, 0}, {0.3, 0.2, 0.6, 0}, {3 * tenth, 0, 3 * tenth, 0}}};
  m[2][1] = 0;
  m[0][1] = 0;
  EXPECT_THROW(Transform{m}, SingularTransform);
  m[2][2] = std::nextafter(m[2][2], 1);
  EXPECT_NO_THROW(Transform{m});
}

TEST(Transform, RayKeepsItsParameter) {
  const Transform t(translation({1, 2, 3}) * scaling({2, 3, 4}));
  const Ray world = t(Ray{{0, 0, 0}, {1, 0, 0}, 1, 5});
  EXPECT_EQ(world.direction, (Vec3{2, 0, 0}));
  EXPECT_EQ(world.t_min, 1);
  EXPECT_EQ(world.t_max, 5);
  EXPECT_EQ(t.inverse_of(world).direction, (Vec3{1, 0, 0}));
}

TEST(Transform, KnowsTheIdentity) {
  EXPECT_TRUE(Transform().is_identity());
  EXPECT_TRUE(Transform(rotation_degrees({0, 0, 0})).is_identity());
  EXPECT_FALSE(Transform(translation({0, 0, 1e-300})).is_identity());
}

}  // namespace
}  // namespace plumb
