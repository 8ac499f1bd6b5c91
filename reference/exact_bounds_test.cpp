#include "reference/exact_bounds.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "reference/exact_bounds_cases_for_tests.h"
#include "reference/exact_bounds_search.h"

namespace plumb {
namespace {

constexpr double kInf = Bounds3::kInfinity;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

double up(double x) { return std::nextafter(x, kInf); }
double down(double x) { return std::nextafter(x, -kInf); }

PlacedShape unit_sphere(const AffineMatrix& matrix = identity_matrix()) {
  PlacedShape placed;
  placed.shape.kind = ShapeKind::sphere;
  placed.world_from_object = matrix;
  return placed;
}

PlacedShape placed_mesh(TriangleMesh mesh) {
  PlacedShape placed;
  placed.shape.kind = ShapeKind::mesh;
  placed.shape.mesh = std::make_shared<TriangleMesh>(std::move(mesh));
  return placed;
}

void expect_box(const PlacedShape& placed, const Point3& min, const Point3& max) {
  const Bounds3 box = exact_bounds(placed);
  EXPECT_EQ(box.min, min) << std::hexfloat << box.min.x << " " << box.min.y << " " << box.min.z;
  EXPECT_EQ(box.max, max) << std::hexfloat << box.max.x << " " << box.max.y << " " << box.max.z;
  for (const auto judge : {judge_bounds, judge_bounds_rational}) {
    const BoundsVerdict verdict = judge(placed, {min, max});
    EXPECT_TRUE(verdict.contains);
    EXPECT_EQ(verdict.ulps_loose, (std::array<std::int64_t, 6>{}));
  }
}

TEST(ExactBounds, SphereThatIsMovedAndStretched) {
  expect_box(unit_sphere(translation({1, 2, 3}) * scaling({2, -4, 0.5})), {-1, -2, 2.5}, {3, 6, 3.5});
}

TEST(ExactBounds, EllipsoidReachesAsFarAsTheRowIsLong) {
  AffineMatrix matrix = identity_matrix();
  matrix[0] = {3, 4, 12, 1};  // length 13
  matrix[1] = {1, 1, 0, 0};   // length sqrt(2) = 0x1.6a09e667f3bcc908...p0
  matrix[2] = {0, 0, 0, 5};
  expect_box(unit_sphere(matrix), {-12, -0x1.6a09e667f3bcdp0, 5}, {14, 0x1.6a09e667f3bcdp0, 5});
}

TEST(ExactBounds, FacesAreRoundedOutwards) {
  // 1 + 2^-60 and -1 + 2^-60 do not fit a double.
  PlacedShape placed = unit_sphere(translation({0x1p-60, -0x1p-60, 0}));
  expect_box(placed, {-1, down(-1), -1}, {up(1), 1, 1});
}

TEST(ExactBounds, CylinderStandsOnItsDiscs) {
  PlacedShape placed;
  placed.shape.kind = ShapeKind::cylinder;
  placed.shape.center = {1, 0, 0};
  placed.shape.radius = 5;
  placed.shape.height = 4;
  expect_box(placed, {-4, -5, -2}, {6, 5, 2});
  placed.world_from_object = {{{0.6, 0, 0, 0}, {0, 0.25, -1, 0}, {1, 0, 1, 0}}};
  // x: 5 * 0.6 and its center 0.6, where the double 0.6 = 0x1.3333333333333p-1 lies below 3/5: 6 * 0.6 is 3.6 rounded
  // up.
  const Bounds3 box = exact_bounds(placed);
  EXPECT_EQ(box.max.y, 2 + 1.25);
  EXPECT_EQ(box.min.z, 1 - 2 - 5);
  EXPECT_GE(mpq_class(box.max.x), 6 * mpq_class(0.6));
  EXPECT_LT(mpq_class(down(box.max.x)), 6 * mpq_class(0.6));
}

TEST(ExactBounds, ConeIsTheHullOfItsEndDiscs) {
  PlacedShape cone;
  cone.shape.kind = ShapeKind::cone;
  cone.shape.radius = 1;  // at the center
  cone.shape.height = 2;  // z from -1 to 1
  cone.shape.tip_z = 1;   // pointed at the top: radius 2 at the bottom
  expect_box(cone, {-2, -2, -1}, {2, 2, 1});
  cone.shape.tip_z = 0.5;  // double: radius 1 at the top, 3 at the bottom
  expect_box(cone, {-3, -3, -1}, {3, 3, 1});
  // A third is no double: radius 4/3 at the bottom.
  cone.shape.tip_z = 3;
  const double reach = exact_bounds(cone).max.x;
  EXPECT_GE(3 * mpq_class(reach), 4);
  EXPECT_LT(3 * mpq_class(down(reach)), 4);
  // Lying on its side and leaning, the wide end reaches furthest down, the narrow one up: x = z + radius / 2.
  cone.shape.tip_z = 1;
  cone.world_from_object = {{{0.5, 0, 1, 0}, {0, 1, 0, 0}, {1, 0, 0, 0}}};
  expect_box(cone, {-2, -2, -2}, {1, 2, 2});
}

TEST(ExactBounds, TriangleAndBoxOfPoints) {
  PlacedShape placed;
  placed.shape.vertices = {{{0, 1, 2}, {3, -1, 0}, {-5, 0, 7}}};
  expect_box(placed, {-5, -1, 0}, {3, 1, 7});
  placed.shape.kind = ShapeKind::box;
  placed.shape.min = {-1, -2, -3};
  placed.shape.max = {1, 2, 3};
  placed.world_from_object = {{{1, -1, 1, 10}, {0, 0, -2, 0}, {0, 0, 0, 4}}};
  expect_box(placed, {4, -6, 4}, {16, 6, 4});
}

TEST(ExactBounds, UnusedVerticesDoNotCount) {
  expect_box(placed_mesh({{{0, 0, 0}, {kNaN, 1e300, 0}, {1, 0, 2}, {0, 3, 0}}, {{0, 2, 3}}, {}, {}}), {0, 0, 0},
             {1, 3, 2});
}

TEST(ExactBounds, NothingHasAnEmptyBox) {
  const PlacedShape nothing = placed_mesh({{{1, 2, 3}}, {}, {}, {}});
  EXPECT_TRUE(exact_bounds(nothing).empty());
  for (const auto judge : {judge_bounds, judge_bounds_rational}) {
    EXPECT_TRUE(judge(nothing, {}).contains);
    EXPECT_EQ(judge(nothing, {}).ulps_loose[0], 0);
    EXPECT_EQ(judge(nothing, {{1, 1, 1}, {0, 0, 0}}).ulps_loose[5], 0);
    const BoundsVerdict loose = judge(nothing, {{0, 0, 0}, {1, 1, 1}});
    EXPECT_TRUE(loose.contains);
    EXPECT_EQ(loose.ulps_loose[3], std::int64_t{1} << 62);
    EXPECT_EQ(loose.relative_looseness, kInf);
    EXPECT_FALSE(judge(nothing, {{0, kNaN, 0}, {1, 1, 1}}).contains);
  }
}

TEST(ExactBounds, BeyondTheDoublesStandsInfinity) {
  PlacedShape huge = unit_sphere(scaling({1e308, 1e308, 5e-324}));
  huge.shape.center = {0, 100, 0};
  huge.shape.radius = 3;
  // y lies between 97e308 and 103e308: above the largest double and below infinity.
  expect_box(huge, {-kInf, std::numeric_limits<double>::max(), -1.5e-323}, {kInf, kInf, 1.5e-323});
}

TEST(ExactBounds, VerdictsCountDoubles) {
  const PlacedShape sphere = unit_sphere();
  const Bounds3 tight{{-1, -1, -1}, {1, 1, 1}};
  for (const auto judge : {judge_bounds, judge_bounds_rational}) {
    Bounds3 claimed = tight;
    claimed.min.x = down(down(-1));
    claimed.max.z = 1.5;
    BoundsVerdict verdict = judge(sphere, claimed);
    EXPECT_TRUE(verdict.contains);
    EXPECT_EQ(verdict.ulps_loose, (std::array<std::int64_t, 6>{2, 0, 0, 0, 0, std::int64_t{1} << 51}));
    EXPECT_EQ(verdict.relative_looseness, 0.25);  // over the extent of 2
    claimed.max.y = down(1);
    verdict = judge(sphere, claimed);
    EXPECT_FALSE(verdict.contains);
    EXPECT_EQ(verdict.ulps_loose[4], -1);
    EXPECT_EQ(verdict.relative_looseness, -0x1p-54);
    EXPECT_FALSE(judge(sphere, {}).contains);
    EXPECT_TRUE(judge(sphere, {{-kInf, -kInf, -kInf}, {kInf, kInf, kInf}}).contains);
    EXPECT_EQ(judge(sphere, {{-kInf, -1, -1}, {1, 1, 1}}).relative_looseness, kInf);
    for (int face = 0; face < 6; ++face) {
      claimed = tight;
      (face < 3 ? claimed.min : claimed.max)[face % 3] = kNaN;
      EXPECT_FALSE(judge(sphere, claimed).contains);
      EXPECT_EQ(judge(sphere, claimed).relative_looseness, -kInf);
    }
  }
}

TEST(ExactBounds, OutsideOfTheDomainThrows) {
  const auto expect_refused = [](const PlacedShape& placed) {
    EXPECT_THROW(exact_bounds(placed), std::invalid_argument);
    EXPECT_THROW(judge_bounds(placed, {}), std::invalid_argument);
    EXPECT_THROW(judge_bounds_rational(placed, {}), std::invalid_argument);
  };
  PlacedShape placed = unit_sphere();
  placed.world_from_object[1][2] = kInf;
  expect_refused(placed);
  placed = unit_sphere();
  placed.shape.radius = -1;
  expect_refused(placed);
  placed.shape.radius = kNaN;
  expect_refused(placed);
  placed = unit_sphere();
  placed.shape.kind = ShapeKind::cone;  // tip at the center
  expect_refused(placed);
  placed.shape.tip_z = 1;
  placed.shape.height = -1;
  expect_refused(placed);
  placed.shape.kind = ShapeKind::box;
  placed.shape.min = {1, 0, 0};
  expect_refused(placed);
  placed.shape.kind = ShapeKind::mesh;
  expect_refused(placed);
  expect_refused(placed_mesh({{{0, 0, 0}}, {{0, 0, 1}}, {}, {}}));
  expect_refused(placed_mesh({{{0, 0, kNaN}}, {{0, 0, 0}}, {}, {}}));
  // What a kind does not use may be anything.
  placed = unit_sphere();
  placed.shape.height = kNaN;
  placed.shape.min.x = kInf;
  EXPECT_NO_THROW(exact_bounds(placed));
}

/// Points that lie exactly on the sphere, as close to where it reaches furthest as doubles tell: within 1e-15 of the
/// direction, so within 1e-30 of the reach. They must lie inside, and outside of a box that is one double smaller.
TEST(ExactBounds, PointsOfSpheresAreWitnesses) {
  PlacedShapeCases cases(4);
  int witnesses = 0, asked = 0;
  for (int i = 0; i < 3000; ++i, ++asked) {
    const PlacedShape placed =
        cases.next(ShapeKind::sphere, i % 2 ? PlacedShapeCases::Style::nested : PlacedShapeCases::Style::steep);
    const auto& row = placed.world_from_object[static_cast<std::size_t>(i % 3)];
    const double axis = std::hypot(row[0], row[1], row[2]);
    // The stereographic projection of the direction, from the pole that lies further away.
    const double side = row[2] < 0 ? -1 : 1;
    const mpq_class u = row[0] / (axis + std::fabs(row[2])), v = row[1] / (axis + std::fabs(row[2]));
    const mpq_class squares = u * u + v * v, radius = placed.shape.radius;
    const mpq_class x = placed.shape.center.x + radius * 2 * u / (1 + squares);
    const mpq_class y = placed.shape.center.y + radius * 2 * v / (1 + squares);
    const mpq_class z = placed.shape.center.z + side * radius * (1 - squares) / (1 + squares);
    const mpq_class reach = row[0] * x + row[1] * y + row[2] * z + row[3];
    const double face = exact_bounds(placed).max[i % 3];
    ASSERT_LE(reach, mpq_class(face));
    witnesses += reach > mpq_class(down(face));
  }
  EXPECT_EQ(asked, 3000);
  EXPECT_GE(witnesses, 2990);
}

TEST(ExactBoundsSearch, FindsEveryDoubleFromEveryGuess) {
  PlacedShapeCases cases(5);
  const double largest = std::numeric_limits<double>::max();
  std::vector<double> doubles{-kInf, -largest, -1, -5e-324, 0, 5e-324, 1, largest, kInf};
  for (int i = 0; i < 40; ++i) doubles.push_back(std::ldexp(cases.uniform(-1, 1), cases.integer(-1070, 1020)));
  int searches = 0;
  for (const double guess : doubles)
    for (const double answer : doubles) {
      if (answer == -kInf) continue;
      ++searches;
      ASSERT_EQ(smallest_that_holds(guess, [&](double x) { return x >= answer; }), answer) << guess;
    }
  EXPECT_EQ(searches, 49 * 48);
  EXPECT_EQ(smallest_that_holds(kNaN, [](double x) { return x >= 2; }), 2);
}

}  // namespace
}  // namespace plumb
