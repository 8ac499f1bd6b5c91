#include <gtest/gtest.h>

#include <cinttypes>
#include <cstdio>

#include "reference/exact_bounds.h"
#include "reference/exact_bounds_cases_for_tests.h"
#include "reference/exact_bounds_face.h"
#include "reference/exact_hit.h"

namespace plumb {
namespace {

using Style = PlacedShapeCases::Style;

std::string hex(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%a", x);
  return text;
}

std::string describe(const PlacedShape& placed) {
  std::string text = "kind " + std::to_string(static_cast<int>(placed.shape.kind)) + ", matrix";
  for (const auto& row : placed.world_from_object)
    for (const double entry : row) text += " " + hex(entry);
  const Shape& s = placed.shape;
  for (const Point3& p : {s.center, s.min, s.max, s.vertices[0], s.vertices[1], s.vertices[2]})
    text += ", point " + hex(p.x) + " " + hex(p.y) + " " + hex(p.z);
  return text + ", radius " + hex(s.radius) + ", height " + hex(s.height) + ", tip " + hex(s.tip_z);
}

double& face_of(Bounds3& box, std::size_t face) {
  const int axis = static_cast<int>(face % 3);
  return face < 3 ? box.min[axis] : box.max[axis];
}

double outward(double x, std::size_t face, bool out) {
  return std::nextafter(x, (face < 3) == out ? -Bounds3::kInfinity : Bounds3::kInfinity);
}

/// Judges the tightest box and its neighbours by both paths.
void expect_agreement(const PlacedShape& placed, std::size_t face) {
  Bounds3 tight = exact_bounds(placed);
  Bounds3 cut = tight, loose = tight;
  face_of(cut, face) = outward(face_of(cut, face), face, false);
  face_of(loose, face) = outward(face_of(loose, face), face, true);
  for (const auto judge : {judge_bounds, judge_bounds_rational}) {
    const BoundsVerdict right = judge(placed, tight), small = judge(placed, cut), large = judge(placed, loose);
    ASSERT_TRUE(right.contains) << describe(placed);
    for (const std::int64_t ulps : right.ulps_loose) ASSERT_EQ(ulps, 0) << describe(placed);
    ASSERT_EQ(right.relative_looseness, 0);
    ASSERT_FALSE(small.contains) << describe(placed);
    ASSERT_EQ(small.ulps_loose[face], -1) << describe(placed);
    // The quotient of a denormal underflows to zero.
    ASSERT_LE(small.relative_looseness, 0);
    ASSERT_TRUE(large.contains) << describe(placed);
    // Beyond infinity there is no double.
    ASSERT_EQ(large.ulps_loose[face], std::isinf(face_of(tight, face)) ? 0 : 1) << describe(placed);
    ASSERT_GE(large.relative_looseness, 0);
  }
}

void expect_paths_agree(ShapeKind kind, int count_per_style) {
  PlacedShapeCases cases(20240 + static_cast<std::uint64_t>(kind));
  int exercised = 0;
  for (const Style style : PlacedShapeCases::kStyles) {
    reset_exact_stages();
    for (int i = 0; i < count_per_style; ++i, ++exercised) {
      ASSERT_NO_FATAL_FAILURE(expect_agreement(cases.next(kind, style), static_cast<std::size_t>(i % 6)));
    }
    const ExactStages stages = exact_stages();
    std::printf("style %d: the filter left %" PRIu64 " of %" PRIu64 " boxes undecided\n", static_cast<int>(style),
                stages.expansion, stages.filter + stages.expansion);
    // Ordinary numbers must seldom need more than the filter, or the oracle is slow.
    if (style == Style::nested || style == Style::steep) {
      EXPECT_LT(stages.expansion * 100, stages.filter);
    }
  }
  EXPECT_EQ(exercised, 5 * count_per_style);
}

TEST(ExactBoundsPaths, AgreeOnTriangles) { expect_paths_agree(ShapeKind::triangle, 500); }
TEST(ExactBoundsPaths, AgreeOnSpheres) { expect_paths_agree(ShapeKind::sphere, 500); }
TEST(ExactBoundsPaths, AgreeOnBoxes) { expect_paths_agree(ShapeKind::box, 500); }
TEST(ExactBoundsPaths, AgreeOnCylinders) { expect_paths_agree(ShapeKind::cylinder, 500); }
TEST(ExactBoundsPaths, AgreeOnCones) { expect_paths_agree(ShapeKind::cone, 500); }
TEST(ExactBoundsPaths, AgreeOnMeshes) { expect_paths_agree(ShapeKind::mesh, 300); }

TEST(ExactBoundsPaths, FilterNeverContradictsPolynomials) {
  PlacedShapeCases cases(77);
  int decided = 0, asked = 0;
  for (int i = 0; i < 12000; ++i) {
    const ShapeKind kind = PlacedShapeCases::kKinds[static_cast<std::size_t>(i % 5)];
    const PlacedShape placed = cases.next(kind, PlacedShapeCases::kStyles[static_cast<std::size_t>(i / 5 % 5)]);
    const Row& row = placed.world_from_object[static_cast<std::size_t>(i % 3)];
    const auto filtered = upper_face_by_filter(placed.shape, {}, row);
    ++asked;
    if (!filtered) continue;
    ++decided;
    ASSERT_EQ(*filtered, upper_face_by_polynomials(placed.shape, {}, row)) << describe(placed);
  }
  EXPECT_EQ(asked, 12000);
  EXPECT_GT(decided, 9000);
}

}  // namespace
}  // namespace plumb
