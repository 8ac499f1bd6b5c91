#include "reference/triangle_hit.h"

#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "reference/exact_hit.h"
#include "reference/triangle_cases_for_tests.h"
#include "reference/triangle_oracle.h"

namespace plumb {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string hex(const TriangleCase& c) {
  std::ostringstream out;
  out << std::hexfloat;
  const auto triple = [&](const auto& v) { out << "{" << v.x << ", " << v.y << ", " << v.z << "} "; };
  for (const Point3& p : c.vertices) triple(p);
  triple(c.ray.origin);
  triple(c.ray.direction);
  out << c.ray.t_min << " " << c.ray.t_max << " matrix";
  for (const auto& row : c.matrix)
    for (const double x : row) out << " " << x;
  return out.str();
}

void expect_same(const ExactHit& a, const ExactHit& b) {
  EXPECT_EQ(a.hit_class, b.hit_class);
  EXPECT_EQ(a.inside, b.inside);
  ASSERT_EQ(a.crossings.size(), b.crossings.size());
  for (std::size_t i = 0; i < a.crossings.size(); ++i) {
    const ExactCrossing &x = a.crossings[i], &y = b.crossings[i];
    EXPECT_EQ(x.t, y.t);
    EXPECT_EQ(x.t_double, y.t_double);
    EXPECT_EQ(x.t_float, y.t_float);
    EXPECT_EQ(x.place, y.place);
    EXPECT_EQ(x.free, y.free);
    EXPECT_EQ(x.part, y.part);
    EXPECT_EQ(x.u, y.u);
    EXPECT_EQ(x.v, y.v);
    EXPECT_EQ(x.position, y.position);
    EXPECT_EQ(x.normal, y.normal);
  }
}

class TrianglePaths : public testing::TestWithParam<std::string> {};

TEST_P(TrianglePaths, AgreeInEveryField) {
  TriangleCases cases(20240);
  std::map<HitClass, int> classes;
  reset_exact_stages();
  constexpr int kCount = 2000;
  for (int i = 0; i < kCount; ++i) {
    const TriangleCase c = cases.next(GetParam());
    const ExactHit filtered = exact_hit(c.shape(), c.ray, ExactPath::filtered);
    expect_same(filtered, exact_hit(c.shape(), c.ray, ExactPath::polynomial));
    expect_same(filtered, exact_hit(c.shape(), c.ray, ExactPath::rational));
    ASSERT_FALSE(HasFailure()) << GetParam() << " case " << i << ": " << hex(c);
    ++classes[filtered.hit_class];
  }
  const ExactStages stages = exact_stages();
  RecordProperty("undecided_per_mille", static_cast<int>((stages.expansion + stages.rational) * 1000 / kCount));
  EXPECT_EQ(classes[HitClass::unsupported], 0);
  // Each family must reach what it was made for.
  const int crossed = classes[HitClass::hit] + classes[HitClass::boundary];
  const bool hits_nothing = GetParam() == "degenerate";
  EXPECT_GT(hits_nothing ? classes[HitClass::miss] : crossed, kCount / 20);
  EXPECT_GT(classes[HitClass::boundary], GetParam().starts_with("lattice") ? kCount / 4 : -1);
  EXPECT_GT(classes[HitClass::singular], GetParam() == "sheared" ? kCount / 10 : -1);
}

INSTANTIATE_TEST_SUITE_P(Family, TrianglePaths, testing::ValuesIn(TriangleCases::families()),
                         [](const auto& test) { return test.param; });

/// The triangle (0,0,0), (4,0,0), (0,4,0) and a ray downwards from height 2.
TriangleCase plain(double x, double y) {
  return {{Point3{0, 0, 0}, Point3{4, 0, 0}, Point3{0, 4, 0}}, {{x, y, 2}, {0, 0, -1}}};
}

ExactHit hit_of(const TriangleCase& c, ExactPath path = ExactPath::filtered) {
  return exact_hit(c.shape(), c.ray, path);
}

TEST(TriangleHit, GivesTheNumbersOfAPlainHit) {
  const ExactHit hit = hit_of(plain(1, 2));
  EXPECT_EQ(hit.hit_class, HitClass::hit);
  ASSERT_EQ(hit.crossings.size(), 1u);
  const ExactCrossing& crossing = hit.crossings[0];
  EXPECT_EQ(crossing.t, (Enclosure{2, 2}));
  EXPECT_EQ(crossing.t_double, 2);
  EXPECT_EQ(crossing.t_float, 2);
  EXPECT_EQ(crossing.u, 0.25);
  EXPECT_EQ(crossing.v, 0.5);
  EXPECT_EQ(crossing.position, (Point3{1, 2, 0}));
  EXPECT_EQ(crossing.normal, (Normal3{0, 0, 1}));
  EXPECT_FALSE(crossing.free);
  EXPECT_FALSE(hit.inside);
}

TEST(TriangleHit, EdgesAndVerticesAreFree) {
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {4.0, 0.0}, {0.0, 4.0}, {2.0, 2.0}, {1.0, 0.0}, {0.0, 3.0}}) {
    const ExactHit hit = hit_of(plain(x, y));
    EXPECT_EQ(hit.hit_class, HitClass::boundary) << x << " " << y;
    ASSERT_EQ(hit.crossings.size(), 1u);
    EXPECT_TRUE(hit.crossings[0].free);
  }
  const double beside = std::nextafter(2.0, 3.0);
  EXPECT_EQ(hit_of(plain(beside, 2)).hit_class, HitClass::miss);
  EXPECT_EQ(hit_of(plain(std::nextafter(2.0, 1.0), 2)).hit_class, HitClass::hit);
  EXPECT_EQ(hit_of(plain(-0x1p-1074, 1)).hit_class, HitClass::miss);
  EXPECT_EQ(hit_of(plain(0x1p-1074, 1)).hit_class, HitClass::hit);
}

TEST(TriangleHit, TheRangeIsClosed) {
  TriangleCase c = plain(1, 1);
  c.ray.t_max = 2;
  EXPECT_EQ(hit_of(c).crossings.at(0).place, RangePlace::at_max);
  c.ray.t_max = std::nextafter(2.0, 0.0);
  EXPECT_EQ(hit_of(c).hit_class, HitClass::miss);
  c.ray.t_max = std::nextafter(2.0, 3.0);
  EXPECT_EQ(hit_of(c).crossings.at(0).place, RangePlace::within);
  c.ray.t_min = 2;
  EXPECT_EQ(hit_of(c).crossings.at(0).place, RangePlace::at_min);
  c.ray = {{1, 1, -2}, {0, 0, -1}};
  EXPECT_EQ(hit_of(c).hit_class, HitClass::miss);
  c.ray.t_min = -kInfinity;
  EXPECT_EQ(hit_of(c).crossings.at(0).t_double, -2);
  c.ray.t_min = kInfinity;
  EXPECT_EQ(hit_of(c).hit_class, HitClass::miss);
}

TEST(TriangleHit, WhatIsNotFiniteIsUnsupported) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto expect_unsupported = [](const TriangleCase& c) {
    for (const ExactPath path : {ExactPath::filtered, ExactPath::polynomial, ExactPath::rational})
      EXPECT_EQ(hit_of(c, path).hit_class, HitClass::unsupported) << hex(c);
    StageCounters counters;
    if (c.matrix == identity_matrix()) {
      const auto& [p, q, r] = c.vertices;
      EXPECT_EQ(decide_triangle(c.ray, p, q, r, counters).hit_class, HitClass::unsupported) << hex(c);
    }
  };
  for (const double bad : {nan, kInfinity, -kInfinity})
    for (int axis = 0; axis < 3; ++axis) {
      for (std::size_t corner = 0; corner < 3; ++corner) {
        TriangleCase c = plain(9, 9);
        c.vertices[corner][axis] = bad;
        expect_unsupported(c);
      }
      for (std::size_t j = 0; j < 4; ++j) {
        TriangleCase c = plain(1, 1);
        c.matrix[static_cast<std::size_t>(axis)][j] = bad;
        expect_unsupported(c);
      }
      TriangleCase origin = plain(1, 1), direction = plain(1, 1);
      origin.ray.origin[axis] = bad;
      direction.ray.direction[axis] = bad;
      expect_unsupported(origin);
      expect_unsupported(direction);
    }
  TriangleCase zero = plain(1, 1), empty = plain(9, 9), no_min = plain(9, 9), no_max = plain(9, 9);
  zero.ray.direction = {0, -0.0, 0};
  empty.ray.t_min = 1;
  empty.ray.t_max = 0;
  no_min.ray.t_min = nan;
  no_max.ray.t_max = nan;
  for (const TriangleCase& c : {zero, empty, no_min, no_max}) expect_unsupported(c);
}

TEST(TriangleHit, AMirroredMatrixKeepsTheOutwardSide) {
  TriangleCase c = plain(-1, 1);
  c.matrix = scaling({-1, 1, 1});
  for (const ExactPath path : {ExactPath::filtered, ExactPath::polynomial, ExactPath::rational})
    EXPECT_EQ(hit_of(c, path).crossings.at(0).normal, (Normal3{0, 0, 1}));
  c.matrix = scaling({1, 1, -1});
  c.ray.origin.x = 1;
  EXPECT_EQ(hit_of(c).crossings.at(0).normal, (Normal3{0, 0, -1}));
  // HARD_CASES M2: diag(2, 1, 1) takes the normal (1, 1, 0) to (1, 2, 0).
  TriangleCase slanted{{Point3{1, 0, 0}, Point3{0, 1, 0}, Point3{0, 1, 1}}, {{3, 0.5, 0.25}, {-1, 0, 0}}};
  slanted.matrix = scaling({2, 1, 1});
  const Normal3 normal = hit_of(slanted).crossings.at(0).normal;
  EXPECT_NEAR(normal.x, 1 / std::sqrt(5.0), 0x1p-52);  // an ulp for each side
  EXPECT_NEAR(normal.y, 2 / std::sqrt(5.0), 0x1p-52);
  EXPECT_EQ(normal.z, 0);
}

TEST(TriangleHit, ASingularMatrixIsNamed) {
  TriangleCase c = plain(1, 1);
  c.matrix = scaling({1, 0, 1});
  for (const ExactPath path : {ExactPath::filtered, ExactPath::polynomial, ExactPath::rational})
    EXPECT_EQ(hit_of(c, path).hit_class, HitClass::singular);
  // Regular, though its determinant underflows in doubles.
  c.matrix = scaling({0x1p-400, 0x1p-400, 0x1p-400});
  EXPECT_EQ(hit_of(c).hit_class, HitClass::miss);
}

TEST(TriangleHit, TheNormalOfANeedleIsExact) {
  // An area of 2^-80 in the plane x = y: nothing is left of its normal in plain doubles.
  const double thin = 1 + 0x1p-52;
  TriangleCase c{{Point3{1, 1, 0}, Point3{thin, thin, 1}, Point3{1 + 0x1p-51, 1 + 0x1p-51, 2 + 0x1p-28}},
                 {{thin + 0.25, thin - 0.25, 1 + 0x1p-30}, {-1, 1, 0}}};
  const ExactHit hit = hit_of(c);
  ASSERT_EQ(hit.hit_class, HitClass::hit);
  EXPECT_NEAR(std::abs(hit.crossings[0].normal.x), std::sqrt(0.5), 0x1p-53);
  EXPECT_EQ(hit.crossings[0].normal.y, -hit.crossings[0].normal.x);
  EXPECT_EQ(hit.crossings[0].normal.z, 0);
}

}  // namespace
}  // namespace plumb
