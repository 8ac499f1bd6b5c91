#include "reference/triangle_oracle.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "reference/triangle_cases_for_tests.h"
#include "reference/triangle_crossing.h"

namespace plumb {
namespace {

using Exact = std::array<mpq_class, 3>;

template <class Triple>
Exact exact(const Triple& v) {
  return {mpq_class(v.x), mpq_class(v.y), mpq_class(v.z)};
}

/// A placed vertex as seen from the origin.
Exact seen(const TriangleCase& c, const Point3& p) {
  Exact result;
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = mpq_class(c.matrix[i][0]) * mpq_class(p.x) + mpq_class(c.matrix[i][1]) * mpq_class(p.y) +
                mpq_class(c.matrix[i][2]) * mpq_class(p.z) + mpq_class(c.matrix[i][3]) -
                mpq_class(c.ray.origin[static_cast<int>(i)]);
  return result;
}

/// a.(b x c), by the rule of Sarrus.
mpq_class determinant(const Exact& a, const Exact& b, const Exact& c) {
  return a[0] * b[1] * c[2] + a[1] * b[2] * c[0] + a[2] * b[0] * c[1] - a[2] * b[1] * c[0] - a[0] * b[2] * c[1] -
         a[1] * b[0] * c[2];
}

struct ExactWeights {
  explicit ExactWeights(const TriangleCase& test)
      : a(seen(test, test.vertices[0])), b(seen(test, test.vertices[1])), c(seen(test, test.vertices[2])) {
    const Exact d = exact(test.ray.direction);
    u = determinant(d, c, b);
    v = determinant(d, a, c);
    w = determinant(d, b, a);
    t = determinant(a, c, b);
  }
  Exact a, b, c;
  mpq_class u, v, w, t;
};

double worst_share(const TriangleCase& c, const TriangleEstimate& estimate) {
  const ExactWeights truth(c);
  const auto share = [](double x, const mpq_class& true_x, double bound) {
    return mpq_class(abs(mpq_class(x) - true_x) / mpq_class(bound)).get_d();
  };
  return std::max({share(estimate.u, truth.u, estimate.weight_bound), share(estimate.v, truth.v, estimate.weight_bound),
                   share(estimate.w, truth.w, estimate.weight_bound), share(estimate.t, truth.t, estimate.t_bound)});
}

class FilterBoundOf : public testing::TestWithParam<std::string> {};

TEST_P(FilterBoundOf, Holds) {
  TriangleCases cases(77);
  double worst = 0;
  int checked = 0;
  for (int i = 0; i < 4000; ++i) {
    const TriangleCase c = cases.next(GetParam());
    const auto& [p, q, r] = c.vertices;
    const bool identity = c.matrix == identity_matrix();
    for (const bool mapped : {true, false}) {
      if (!mapped && !identity) continue;
      const SeenTriangle seen_by_filter =
          mapped ? MappedTriangles(c.matrix, c.ray.origin)(p, q, r) : seen_triangle(c.ray.origin, p, q, r);
      const TriangleEstimate estimate = estimate_triangle(seen_by_filter, c.ray.direction);
      if (std::isinf(estimate.weight_bound)) continue;
      worst = std::max(worst, worst_share(c, estimate));
      ++checked;
    }
    ASSERT_LE(worst, 1) << i;
  }
  RecordProperty("worst_error_over_bound_per_mille", static_cast<int>(1000 * worst));
  EXPECT_GE(checked, GetParam() == "denormal" ? 0 : GetParam() == "extreme" ? 100 : 3900);
}

INSTANTIATE_TEST_SUITE_P(Family, FilterBoundOf, testing::ValuesIn(TriangleCases::families()),
                         [](const auto& test) { return test.param; });

TEST(FilterBound, HoldsBesideItsGuards) {
  TriangleCases cases(78);
  int checked = 0;
  for (int i = 0; i < 4000; ++i) {
    TriangleCase c = cases.next(i % 2 == 0 ? "edge" : "lattice");
    const int vertices = cases.coin() ? 198 : -201, direction = cases.coin() ? 197 : -203;
    // Some components so small that products with them underflow.
    const auto scale = [&](auto& v, int exponent) {
      for (int axis = 0; axis < 3; ++axis)
        v[axis] = std::ldexp(v[axis], exponent - (cases.whole(0, 2) == 0 ? cases.whole(300, 900) : 0));
    };
    for (Point3& p : c.vertices) scale(p, vertices);
    scale(c.ray.origin, vertices);
    scale(c.ray.direction, direction);
    const auto& [p, q, r] = c.vertices;
    const TriangleEstimate estimate = estimate_triangle(seen_triangle(c.ray.origin, p, q, r), c.ray.direction);
    if (std::isinf(estimate.weight_bound)) continue;
    ASSERT_LE(worst_share(c, estimate), 1) << i;
    ++checked;
  }
  EXPECT_GT(checked, 1000);
}

TEST(FilterBound, NothingIsDecidedOutsideOfTheGuards) {
  const auto verdict = [](double size, double t_max) {
    const Point3 a{-size, -size, -size}, b{size, -size, -size}, c{0, size, -size};
    return judge_estimate(estimate_triangle(seen_triangle({0, 0, 0}, a, b, c), {0, 0, -1}), 0, t_max);
  };
  EXPECT_EQ(verdict(1, HUGE_VAL), FilterVerdict::hit);
  EXPECT_EQ(verdict(1, 0.5), FilterVerdict::miss);
  EXPECT_EQ(verdict(1, 1), FilterVerdict::undecided);
  EXPECT_EQ(verdict(1, 1e300), FilterVerdict::hit);
  EXPECT_EQ(verdict(1, 1e308), FilterVerdict::undecided);  // t_max D overflows
  for (const double size : {0x1p-201, 0x1p201, 1e308, 0x1p-1074, HUGE_VAL, std::nan("")})
    EXPECT_EQ(verdict(size, HUGE_VAL), FilterVerdict::undecided) << size;
}

Sign sign_of(const mpq_class& x) { return static_cast<Sign>(sgn(x)); }

bool agrees(Sign claimed, const mpq_class& truth) { return claimed == Sign::unknown || claimed == sign_of(truth); }

class Decision : public testing::TestWithParam<std::string> {};

TEST_P(Decision, IsThatOfTheRationalPathWithTrueSigns) {
  TriangleCases cases(99);
  int undecided = 0;
  for (int i = 0; i < 2000; ++i) {
    TriangleCase c = cases.next(GetParam());
    c.matrix = identity_matrix();
    const auto& [p, q, r] = c.vertices;
    const auto crossing = RationalTriangles(c.matrix, c.ray).crossing(p, q, r);
    const HitClass expected = !crossing ? HitClass::miss : crossing->boundary ? HitClass::boundary : HitClass::hit;
    const ExactWeights truth(c);
    StageCounters counters;
    for (const TriangleDecision& decision :
         {decide_triangle(c.ray, p, q, r, counters), decide_triangle_exactly(c.ray, p, q, r, counters),
          decide_triangle_by_numbers(c.ray, p, q, r)}) {
      ASSERT_EQ(decision.hit_class, expected) << i;
      ASSERT_TRUE(agrees(decision.u, truth.u) && agrees(decision.v, truth.v) && agrees(decision.w, truth.w)) << i;
      ASSERT_TRUE(agrees(decision.d, truth.u + truth.v + truth.w) && agrees(decision.t, truth.t)) << i;
      if (decision.by == DecidedBy::filter && expected == HitClass::miss) continue;
      ASSERT_TRUE(decision.u != Sign::unknown && decision.v != Sign::unknown && decision.w != Sign::unknown);
    }
    undecided += counters.filter == 0;
    EXPECT_EQ(counters.filter + counters.expansion + counters.rational, 2u);
  }
  EXPECT_LE(undecided, GetParam() == "control" ? 5 : 2000);
}

INSTANTIATE_TEST_SUITE_P(Family, Decision, testing::ValuesIn(TriangleCases::families()),
                         [](const auto& test) { return test.param; });

TEST(EdgeMargin, CountsUnitsOfRoundoff) {
  // |d|_1 = 1, s = 2 (the depth), e = 2.
  const Point3 a{-1, -1, -2}, b{1, -1, -2}, c{-1, 1, -2};
  const Ray near_edge{{-1 + 0x1p-30, -0.5, 0}, {0, 0, -1}};
  // The distance to the edge x = -1 is 2^-30, its weight 2 * 2^-30.
  EXPECT_EQ(edge_margin(near_edge, a, b, c, 0x1p-24), 2 * 0x1p-30 / (2 * 2) * 0x1p24);
  EXPECT_EQ(edge_margin(near_edge, a, b, c, 0x1p-53), 2 * 0x1p-30 / (2 * 2) * 0x1p53);
  EXPECT_EQ(edge_margin({{0, 0, 0}, {0, 0, -1}}, a, b, c, 0x1p-24), 0);
  EXPECT_EQ(edge_margin(near_edge, a, a, a, 0x1p-24), 0);
  EXPECT_TRUE(std::isnan(edge_margin({{std::nan(""), 0, 0}, {0, 0, -1}}, a, b, c, 0x1p-24)));
}

}  // namespace
}  // namespace plumb
