#include "reference/exact_transform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "reference/exact_bounds_cases_for_tests.h"
#include "reference/exact_transform_cross_check.h"

namespace plumb {
namespace {

using Kind = TransformStep::Kind;

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

bool exact_or_neighbours(const Enclosure& e) { return e.exact() || std::nextafter(e.below, kInf) == e.above; }

std::string hex(const Enclosure& e) {
  std::ostringstream out;
  out << std::hexfloat << " [" << e.below << ", " << e.above << "]";
  return out.str();
}

/// Entry by entry, and that each is a proper enclosure.
template <class Matrix>
void expect_same(const Matrix& a, const Matrix& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < a[i].size(); ++j) {
      ASSERT_EQ(a[i][j], b[i][j]) << i << j << hex(a[i][j]) << hex(b[i][j]);
      ASSERT_TRUE(exact_or_neighbours(a[i][j])) << hex(a[i][j]);
    }
}

void expect_exactly(const EnclosedMatrix& a, const AffineMatrix& b) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 4; ++j) ASSERT_EQ(a[i][j], (Enclosure{b[i][j], b[i][j]})) << i << j << hex(a[i][j]);
}

/// Angles that tempt: right ones and their neighbours, multiples of 15, tiny, huge and ordinary ones.
double angle(PlacedShapeCases& cases, int choice) {
  switch (choice % 6) {
    case 0:
      return 90.0 * cases.integer(-8, 8);
    case 1:
      return 15.0 * cases.integer(-48, 48);
    case 2:
      return std::nextafter(30.0 * cases.integer(-24, 24), cases.integer(0, 1) ? 1e9 : -1e9);
    case 3:
      return std::ldexp(cases.uniform(-1, 1), cases.integer(-1070, 0));
    case 4:
      return std::ldexp(cases.uniform(-1, 1), cases.integer(10, 1023));
    default:
      return cases.uniform(-720, 720);
  }
}

std::vector<TransformStep> steps(PlacedShapeCases& cases, int depth, int choice) {
  std::vector<TransformStep> result;
  for (int i = 0; i < depth; ++i) {
    const auto kind = static_cast<Kind>(cases.integer(0, 2));
    Vec3 value;
    for (int axis = 0; axis < 3; ++axis)
      value[axis] = kind == Kind::rotate ? angle(cases, choice % 2 ? 5 : cases.integer(0, 5))
                    : kind == Kind::scale
                        ? std::ldexp(cases.uniform(1, 2), cases.integer(-6, 6)) * (cases.integer(0, 1) ? 1 : -1)
                        : cases.uniform(-100, 100);
    result.push_back({kind, value});
  }
  return result;
}

TEST(CertifiedCosSin, IsExactWhereItIsRational) {
  const std::array<double, 4> cosines{1, 0, -1, 0};
  for (int turn = -8; turn <= 8; ++turn) {
    const auto c = static_cast<std::size_t>((turn + 8) % 4), s = static_cast<std::size_t>((turn + 11) % 4);
    for (const EnclosedCosSin& cs : {certified_cos_sin(90.0 * turn), certified_cos_sin_by_radians(90.0 * turn, 256)}) {
      EXPECT_EQ(cs.cos, (Enclosure{cosines[c], cosines[c]})) << turn;
      EXPECT_EQ(cs.sin, (Enclosure{cosines[s], cosines[s]})) << turn;
    }
  }
  EXPECT_EQ(certified_cos_sin(60).cos, (Enclosure{0.5, 0.5}));
  EXPECT_EQ(certified_cos_sin(-30).sin, (Enclosure{-0.5, -0.5}));
  EXPECT_EQ(certified_cos_sin(1e300 * 0).sin, (Enclosure{0, 0}));
  // cos 45 = sqrt(1/2) = 0x1.6a09e667f3bcc908...p-1.
  EXPECT_EQ(certified_cos_sin(45).cos, (Enclosure{0x1.6a09e667f3bccp-1, 0x1.6a09e667f3bcdp-1}));
  EXPECT_TRUE(std::isnan(certified_cos_sin(kInf).cos.below));
  EXPECT_TRUE(std::isnan(certified_cos_sin_by_radians(kNaN, 256).sin.above));
  // The smallest angle: its sine, 5e-324 pi/180, lies between zero and the smallest denormal.
  EXPECT_EQ(certified_cos_sin(5e-324).sin, (Enclosure{0, 5e-324}));
  EXPECT_EQ(certified_cos_sin(5e-324).cos, (Enclosure{std::nextafter(1, 0), 1}));
}

TEST(CertifiedCosSin, AgreesWithRadiansAtTwoPrecisions) {
  PlacedShapeCases cases(1);
  int asked = 0;
  for (int i = 0; i < 6000; ++i, ++asked) {
    const double degrees = angle(cases, i);
    const EnclosedCosSin first = certified_cos_sin(degrees);
    ASSERT_TRUE(exact_or_neighbours(first.cos) && exact_or_neighbours(first.sin)) << std::hexfloat << degrees;
    // The cosine of the tiniest angle differs from 1 by 2^-2160, which is beyond these precisions: wider, not wrong.
    for (const int bits : {256, 640}) {
      const EnclosedCosSin second = certified_cos_sin_by_radians(degrees, bits);
      ASSERT_EQ(first.sin, second.sin) << std::hexfloat << degrees;
      if (std::fabs(degrees) > 0x1p-100 || degrees == 0)
        ASSERT_EQ(first.cos, second.cos) << std::hexfloat << degrees;
      else
        ASSERT_EQ(second.cos.above, 1) << std::hexfloat << degrees;
    }
    // What the C library says lies within an ulp of its argument's rounding for ordinary angles: |x| 2^-53 and half an
    // ulp of 1 for the result.
    if (i % 6 != 5) continue;
    const double radians = degrees * (std::numbers::pi / 180);
    ASSERT_NEAR(std::cos(radians), first.cos.below, (std::fabs(radians) * 2 + 2) * 0x1p-53);
    ASSERT_NEAR(std::sin(radians), first.sin.below, (std::fabs(radians) * 2 + 2) * 0x1p-53);
  }
  EXPECT_EQ(asked, 6000);
}

TEST(CertifiedProduct, RotationsByRightAnglesAreExact) {
  const std::vector<TransformStep> about_z{{Kind::rotate, {0, 0, 90}}};
  expect_exactly(certified_product(about_z), {{{0, -1, 0, 0}, {1, 0, 0, 0}, {0, 0, 1, 0}}});
  // x first: e_y goes to e_z, and about z that stays.
  const std::vector<TransformStep> in_order{{Kind::rotate, {90, 0, 90}}};
  expect_exactly(certified_product(in_order), {{{0, 0, 1, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}}});
  const std::vector<TransformStep> half_turns{{Kind::rotate, {180, 270, -90}}, {Kind::translate, {1, 2, 3}}};
  EXPECT_EQ(certified_product(half_turns), certified_product_by_quaternions(half_turns, 1280));
  for (const auto& row : certified_product(half_turns))
    for (const Enclosure& entry : row) EXPECT_TRUE(entry.exact());
}

TEST(CertifiedProduct, TheFirstStepIsOutermost) {
  const std::vector<TransformStep> list{
      {Kind::translate, {1, 2, 3}}, {Kind::scale, {2, 3, 4}}, {Kind::translate, {10, 10, 10}}};
  expect_exactly(certified_product(list), {{{2, 0, 0, 21}, {0, 3, 0, 32}, {0, 0, 4, 43}}});
  EnclosedMatrix inverse;
  ASSERT_TRUE(certified_inverse(list, inverse));
  EXPECT_EQ(inverse[0][0], (Enclosure{0.5, 0.5}));
  EXPECT_EQ(inverse[0][3], (Enclosure{-10.5, -10.5}));
  // 1/3 and -32/3 are no doubles.
  EXPECT_EQ(inverse[1][1], (Enclosure{0x1.5555555555555p-2, 0x1.5555555555556p-2}));
  EXPECT_EQ(inverse[1][3], (Enclosure{-0x1.5555555555556p3, -0x1.5555555555555p3}));
  EXPECT_EQ(certified_product(std::vector<TransformStep>{})[1][1], (Enclosure{1, 1}));
}

TEST(CertifiedProduct, TwoHalvesOfARightAngleMakeOne) {
  const std::vector<TransformStep> twice{{Kind::rotate, {0, 0, 45}}, {Kind::rotate, {0, 0, 45}}};
  expect_exactly(certified_product(twice), {{{0, -1, 0, 0}, {1, 0, 0, 0}, {0, 0, 1, 0}}});
}

TEST(CertifiedProduct, WhatCannotBeToldFromADoubleIsTakenForIt) {
  // The cosine of 1e-320 degrees is 1 - 2^-2138 or so.
  EXPECT_EQ(certified_cos_sin(1e-320).cos, (Enclosure{std::nextafter(1, 0), 1}));
  const std::vector<TransformStep> tiny{{Kind::rotate, {1e-320, 0, 0}}};
  EXPECT_EQ(certified_product(tiny)[1][1], (Enclosure{1, 1}));
  EXPECT_EQ(certified_product(tiny)[2][1], certified_cos_sin(1e-320).sin);
}

TEST(CertifiedProduct, StepsAgreeWithQuaternions) {
  PlacedShapeCases cases(2);
  int asked = 0;
  for (int i = 0; i < 1000; ++i, ++asked) {
    const std::vector<TransformStep> list = steps(cases, 1 + i % 8, i);
    // Zeros among the right angles, and tiny angles, need the longer one.
    const EnclosedMatrix first = certified_product(list);
    ASSERT_NO_FATAL_FAILURE(expect_same(first, certified_product_by_quaternions(list, i % 2 ? 512 : 2048))) << i;
  }
  EXPECT_EQ(asked, 1000);
}

TEST(CertifiedInverse, OfStepsAgreesWithQuaternions) {
  PlacedShapeCases cases(3);
  int asked = 0;
  for (int i = 0; i < 600; ++i, ++asked) {
    const std::vector<TransformStep> list = steps(cases, 1 + i % 8, 1);
    EnclosedMatrix first, second;
    ASSERT_TRUE(certified_inverse(list, first));
    ASSERT_TRUE(certified_inverse_by_quaternions(list, i % 2 ? 640 : 1280, second));
    ASSERT_NO_FATAL_FAILURE(expect_same(first, second)) << i;
  }
  EXPECT_EQ(asked, 600);
}

TEST(CertifiedProduct, OfMatricesAgreesWithExpansions) {
  PlacedShapeCases cases(4);
  int asked = 0;
  for (int i = 0; i < 3000; ++i, ++asked) {
    std::vector<AffineMatrix> matrices;
    const auto style = PlacedShapeCases::kStyles[static_cast<std::size_t>(i % 5)];
    for (int depth = 0; depth <= i % 4; ++depth)
      matrices.push_back(cases.next(ShapeKind::sphere, style).world_from_object);
    ASSERT_NO_FATAL_FAILURE(expect_same(certified_product(matrices), certified_product_by_expansions(matrices))) << i;
  }
  EXPECT_EQ(asked, 3000);
}

TEST(CertifiedInverse, AgreesWithElimination) {
  PlacedShapeCases cases(5);
  int regular = 0, singular = 0;
  for (int i = 0; i < 5000; ++i) {
    const auto style = PlacedShapeCases::kStyles[static_cast<std::size_t>(i % 5)];
    const AffineMatrix matrix = cases.next(ShapeKind::sphere, style).world_from_object;
    EnclosedMatrix first, second;
    EnclosedMatrix3 transposed;
    const bool invertible = certified_inverse(matrix, first);
    ASSERT_EQ(invertible, certified_inverse_by_elimination(matrix, second)) << i;
    ASSERT_EQ(invertible, certified_inverse_transpose(matrix, transposed)) << i;
    ++(invertible ? regular : singular);
    if (!invertible) {
      ASSERT_TRUE(std::isnan(first[0][0].below) && std::isinf(condition_number(matrix)));
      continue;
    }
    ASSERT_NO_FATAL_FAILURE(expect_same(first, second)) << i;
    for (std::size_t row = 0; row < 3; ++row)
      for (std::size_t column = 0; column < 3; ++column) ASSERT_EQ(transposed[row][column], first[column][row]);
  }
  EXPECT_EQ(regular + singular, 5000);
  EXPECT_GT(regular, 3500);
  EXPECT_GT(singular, 900);
}

TEST(CertifiedInverse, KnownAnswers) {
  EnclosedMatrix inverse;
  const AffineMatrix mirrored{{{0, 2, 0, 6}, {-4, 0, 0, 8}, {0, 0, -8, 16}}};
  ASSERT_TRUE(certified_inverse(mirrored, inverse));
  expect_exactly(inverse, {{{0, -0.25, 0, 2}, {0.5, 0, 0, -3}, {0, 0, -0.125, 2}}});
  // A determinant of 2^-52, which naive arithmetic on the entries still sees, and of zero, which it may not.
  const AffineMatrix nearly{{{1, 1, 0, 0}, {1, 1 + 0x1p-52, 0, 0}, {0, 0, 1, 0}}};
  ASSERT_TRUE(certified_inverse(nearly, inverse));
  EXPECT_EQ(inverse[0][1], (Enclosure{-0x1p52, -0x1p52}));
  EXPECT_FALSE(certified_inverse(AffineMatrix{{{0.1, 0.2, 0, 0}, {0.2, 0.4, 0, 0}, {0, 0, 1, 0}}}, inverse));
  // The reciprocal of the smallest double overflows, that of the largest one is denormal.
  ASSERT_TRUE(certified_inverse(scaling({5e-324, std::numeric_limits<double>::max(), 1}), inverse));
  EXPECT_EQ(inverse[0][0], (Enclosure{std::numeric_limits<double>::max(), kInf}));
  EXPECT_EQ(inverse[1][1], (Enclosure{0x1p-1024, std::nextafter(0x1p-1024, 1)}));
}

TEST(CertifiedInverse, RefusesWhatHasNone) {
  EnclosedMatrix inverse;
  const std::vector<TransformStep> flat{{Kind::rotate, {1, 2, 3}}, {Kind::scale, {1, 0, 1}}};
  EXPECT_FALSE(certified_inverse(flat, inverse));
  EXPECT_FALSE(certified_inverse_by_quaternions(flat, 256, inverse));
  AffineMatrix bad = identity_matrix();
  bad[1][3] = kNaN;
  EXPECT_FALSE(certified_inverse(bad, inverse));
  EXPECT_TRUE(std::isnan(inverse[0][0].below));
  EXPECT_TRUE(std::isnan(condition_number(bad)));
  EXPECT_TRUE(std::isnan(certified_product(std::vector<AffineMatrix>{bad})[0][0].below));
  EXPECT_TRUE(std::isnan(certified_product(std::vector<TransformStep>{{Kind::scale, {1, kInf, 1}}})[0][0].below));
}

TEST(ConditionNumber, KnownAnswers) {
  EXPECT_EQ(condition_number(identity_matrix()), 1);
  EXPECT_EQ(condition_number(scaling({1, 4, 0.25})), 16);
  EXPECT_EQ(condition_number(translation({1e9, 0, 0})), 1);
  EXPECT_EQ(condition_number({{{1, 2, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}}), 9);
  EXPECT_EQ(condition_number(scaling({1, 1, 0})), kInf);
}

TEST(ConditionNumber, OfSteepMatricesReachesItsTarget) {
  PlacedShapeCases cases(6);
  double largest = 0;
  for (int i = 0; i < 1000; ++i)
    largest = std::fmax(
        largest, condition_number(cases.next(ShapeKind::sphere, PlacedShapeCases::Style::steep).world_from_object));
  EXPECT_GT(largest, 1e11);
  // 1e12 in the spectral norm, which differs from the row sums by a factor of at most 3 in all.
  EXPECT_LT(largest, 3.001e12);
}

}  // namespace
}  // namespace plumb
