#include "reference/solid_hit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "reference/algebraic_t.h"
#include "reference/solid_cases_for_tests.h"

namespace plumb {
namespace {

constexpr double kInfinity = Bounds3::kInfinity;
constexpr double kHalfRoot = 0x1.6a09e667f3bcdp-1;  // sqrt(1/2)

Shape sphere(const Point3& center, double radius) {
  return {.kind = ShapeKind::sphere, .center = center, .radius = radius};
}
Shape box(const Point3& low, const Point3& high) { return {.kind = ShapeKind::box, .min = low, .max = high}; }
Shape cylinder(double radius, double height) {
  return {.kind = ShapeKind::cylinder, .radius = radius, .height = height};
}
/// About the origin, its tip at z = 1 and its side at 45 degrees.
Shape cone(double height) { return {.kind = ShapeKind::cone, .radius = 1, .height = height, .tip_z = 1}; }

Ray line(const Point3& origin, const Vec3& direction) { return {origin, direction, -kInfinity, kInfinity}; }

/// The answer, after all three paths have given it.
ExactHit ask(const PlacedShape& placed, const Ray& ray) {
  StageCounters counters;
  const ExactHit hit = solid_hit(placed, ray, ExactPath::filtered, counters);
  EXPECT_EQ(difference(hit, solid_hit(placed, ray, ExactPath::polynomial, counters)), "") << describe(placed, ray);
  EXPECT_EQ(difference(hit, solid_hit(placed, ray, ExactPath::rational, counters)), "") << describe(placed, ray);
  return hit;
}
ExactHit ask(const Shape& shape, const Ray& ray) { return ask(PlacedShape{shape}, ray); }

struct Expected {
  double t;
  std::uint32_t part;
  Normal3 normal;
};

/// Exact t, all free or none, within the range.
void expect(const ExactHit& hit, HitClass hit_class, const std::vector<Expected>& crossings) {
  EXPECT_EQ(hit.hit_class, hit_class);
  ASSERT_EQ(hit.crossings.size(), crossings.size());
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    const ExactCrossing& c = hit.crossings[i];
    EXPECT_EQ(c.t, (Enclosure{crossings[i].t, crossings[i].t}));
    EXPECT_EQ(c.t_double, crossings[i].t);
    EXPECT_EQ(c.t_float, static_cast<float>(crossings[i].t));
    EXPECT_EQ(c.part, crossings[i].part);
    EXPECT_EQ(c.normal, crossings[i].normal) << c.normal.x << " " << c.normal.y << " " << c.normal.z;
    EXPECT_EQ(c.free, hit_class != HitClass::hit);
    EXPECT_EQ(c.place, RangePlace::within);
  }
}

TEST(SolidSphere, IsEnteredAndLeft) {
  const ExactHit hit = ask(sphere({}, 1), line({0, 0, 5}, {0, 0, -1}));
  expect(hit, HitClass::hit, {{4, 0, {0, 0, 1}}, {6, 0, {0, 0, -1}}});
  EXPECT_EQ(hit.crossings[0].position, (Point3{0, 0, 1}));
  EXPECT_FALSE(hit.inside);
  EXPECT_TRUE(ask(sphere({}, 1), line({0, 0.5, 0}, {0, 0, -1})).inside);
  EXPECT_FALSE(ask(sphere({}, 1), line({0, 1, 0}, {0, 0, -1})).inside);
}

TEST(SolidSphere, IrrationalRootsAreEnclosed) {
  // t = 5 - sqrt(3) / 2 = 4.13397459621556135323627682924706381652859... by its published decimals.
  const ExactHit hit = ask(sphere({}, 1), {{0.5, 0, 5}, {0, 0, -1}});
  ASSERT_EQ(hit.crossings.size(), 2U);
  const ExactCrossing& c = hit.crossings[0];
  EXPECT_EQ(c.t_double, 4.13397459621556135323627682924706381652859);
  EXPECT_EQ(c.t_float, 4.13397459621556135323627682924706381652859F);
  EXPECT_EQ(std::nextafter(c.t.below, kInfinity), c.t.above);
  EXPECT_FALSE(c.t.exact());
  EXPECT_TRUE(c.t_double == c.t.below || c.t_double == c.t.above);
  EXPECT_EQ(c.position, (Point3{0.5, 0, 0.866025403784438646763723170752936183471}));
  EXPECT_LE(std::fabs(c.normal.z - 0.866025403784438646763723170752936183471), 0x1p-52);
}

TEST(SolidSphere, TheRangeIsClosed) {
  const auto at = [](double low, double high) { return ask(sphere({}, 1), {{0, 0, 5}, {0, 0, -1}, low, high}); };
  EXPECT_EQ(at(4, 6).crossings.front().place, RangePlace::at_min);
  EXPECT_EQ(at(4, 6).crossings.back().place, RangePlace::at_max);
  EXPECT_EQ(at(4, 4).crossings.front().place, RangePlace::at_min);
  EXPECT_EQ(at(std::nextafter(4, 5), 6).crossings.size(), 1U);
  EXPECT_EQ(at(4.5, 5.5).hit_class, HitClass::miss);
  EXPECT_EQ(at(kInfinity, kInfinity).hit_class, HitClass::miss);
  EXPECT_EQ(at(-kInfinity, -kInfinity).hit_class, HitClass::miss);
  // An origin on the surface is a crossing at t = 0.
  const ExactHit on = ask(sphere({}, 3), {{1, -2, 2}, {1, 0, 0}});
  ASSERT_EQ(on.crossings.size(), 1U);
  EXPECT_EQ(on.crossings[0].place, RangePlace::at_min);
  EXPECT_EQ(on.crossings[0].t, (Enclosure{0, 0}));
}

TEST(SolidSphere, TangentsAreOneFreeCrossing) {
  // (0.6, 0.8, 0) to multiples of 2^-52.
  expect(ask(sphere({}, 5), line({3, 4, -7}, {0, 0, 1})), HitClass::tangent,
         {{7, 0, {0x1.3333333333334p-1, 0x1.999999999999ap-1, 0}}});
  EXPECT_EQ(ask(sphere({}, std::nextafter(5, 6)), line({3, 4, -7}, {0, 0, 1})).crossings.size(), 2U);
  EXPECT_EQ(ask(sphere({}, std::nextafter(5, 4)), line({3, 4, -7}, {0, 0, 1})).hit_class, HitClass::miss);
  expect(ask(sphere({1, 2, 3}, 0), line({0, 2, 3}, {2, 0, 0})), HitClass::tangent, {{0.5, 0, {0, 0, 1}}});
}

TEST(SolidBox, FacesAreNumberedByAxis) {
  const Shape cube = box({-1, -1, -1}, {1, 1, 1});
  expect(ask(cube, line({0, 0, 5}, {0, 0, -1})), HitClass::hit, {{4, 5, {0, 0, 1}}, {6, 4, {0, 0, -1}}});
  expect(ask(cube, line({-3, 0, 0.5}, {2, -0.0, 0})), HitClass::hit, {{1, 0, {-1, 0, 0}}, {2, 1, {1, 0, 0}}});
  EXPECT_TRUE(ask(cube, line({0, 0.5, 0}, {1, 1, 1})).inside);
  EXPECT_FALSE(ask(cube, line({0, 1, 0}, {1, 1, 1})).inside);
  EXPECT_EQ(ask(cube, line({0, 1.5, 0}, {1, 0, 0})).hit_class, HitClass::miss);
}

TEST(SolidBox, EdgesAndCornersEnteredAreProperAndTouchedAreFree) {
  const Shape cube = box({-1, -1, -1}, {1, 1, 1});
  // Corner to corner, and edge to edge: the lowest face that holds the point.
  expect(ask(cube, line({-3, -3, -3}, {1, 1, 1})), HitClass::hit, {{2, 0, {-1, 0, 0}}, {4, 1, {1, 0, 0}}});
  expect(ask(cube, line({0, -3, 3}, {0, 1, -1})), HitClass::hit, {{2, 2, {0, -1, 0}}, {4, 3, {0, 1, 0}}});
  // Past an edge, past a corner.
  expect(ask(cube, line({0, -1, 3}, {0, 1, -1})), HitClass::boundary, {{2, 3, {0, 1, 0}}});
  expect(ask(cube, line({3, 0, 0}, {-2, 1, 1})), HitClass::boundary, {{1, 1, {1, 0, 0}}});
  // Within a face, and along an edge.
  expect(ask(cube, line({-3, 0, 1}, {1, 0, 0})), HitClass::boundary, {{2, 0, {-1, 0, 0}}, {4, 1, {1, 0, 0}}});
  expect(ask(cube, line({1, 1, 3}, {0, 0, -1})), HitClass::boundary, {{2, 1, {1, 0, 0}}, {4, 1, {1, 0, 0}}});
}

TEST(SolidBox, WithoutThicknessItIsStillThere) {
  const Shape sheet = box({0, 0, 1}, {2, 2, 1});
  expect(ask(sheet, line({1, 1, 5}, {0, 0, -1})), HitClass::hit, {{4, 4, {0, 0, -1}}});
  expect(ask(sheet, line({0, 1, 5}, {0, 0, -1})), HitClass::boundary, {{4, 0, {-1, 0, 0}}});
  expect(ask(sheet, line({-1, 1, 1}, {1, 0, 0})), HitClass::boundary, {{1, 0, {-1, 0, 0}}, {3, 1, {1, 0, 0}}});
  const Shape rod = box({0, 0, 1}, {2, 0, 1});
  expect(ask(rod, line({1, 0, 5}, {0, 0, -1})), HitClass::boundary, {{4, 2, {0, -1, 0}}});
  expect(ask(rod, line({-1, 0, 1}, {1, 0, 0})), HitClass::boundary, {{1, 0, {-1, 0, 0}}, {3, 1, {1, 0, 0}}});
  expect(ask(box({1, 2, 3}, {1, 2, 3}), line({0, 0, 0}, {1, 2, 3})), HitClass::boundary, {{1, 0, {-1, 0, 0}}});
  EXPECT_FALSE(ask(sheet, line({1, 1, 1}, {1, 0, 0})).inside);
}

TEST(SolidCylinder, CapsAndSide) {
  const Shape can = cylinder(1, 4);
  expect(ask(can, line({0, 0.5, 5}, {0, 0, -1})), HitClass::hit, {{3, 2, {0, 0, 1}}, {7, 1, {0, 0, -1}}});
  expect(ask(can, line({-3, 0, 1}, {1, 0, 0})), HitClass::hit, {{2, 0, {-1, 0, 0}}, {4, 0, {1, 0, 0}}});
  // From rim to rim: the side is the lowest face there.
  expect(ask(can, line({-3, 0, -6}, {1, 0, 2})), HitClass::hit, {{2, 0, {-1, 0, 0}}, {4, 0, {1, 0, 0}}});
  EXPECT_EQ(ask(can, line({0, 2, 5}, {0, 0, -1})).hit_class, HitClass::miss);
  EXPECT_EQ(ask(can, line({-3, 0, 2.5}, {1, 0, 0})).hit_class, HitClass::miss);
  EXPECT_TRUE(ask(can, line({0.5, 0, 1.5}, {1, 0, 0})).inside);
  EXPECT_FALSE(ask(can, line({0.5, 0, 2}, {1, 0, 0})).inside);
}

TEST(SolidCylinder, Touched) {
  const Shape can = cylinder(1, 4);
  expect(ask(can, line({-3, 1, 0}, {1, 0, 0})), HitClass::tangent, {{3, 0, {0, 1, 0}}});
  expect(ask(can, line({1, 0, 5}, {0, 0, -1})), HitClass::boundary, {{3, 0, {1, 0, 0}}, {7, 0, {1, 0, 0}}});
  // A rim crossed outwards, and one touched along its tangent.
  expect(ask(can, line({0, 0, 3}, {1, 0, -1})), HitClass::boundary, {{1, 0, {1, 0, 0}}});
  expect(ask(can, line({-3, 1, 2}, {1, 0, 0})), HitClass::tangent, {{3, 0, {0, 1, 0}}});
  // In the plane of a cap.
  expect(ask(can, line({-3, 0, 2}, {1, 0, 0})), HitClass::boundary, {{2, 0, {-1, 0, 0}}, {4, 0, {1, 0, 0}}});
}

TEST(SolidCylinder, WithoutHeightOrRadius) {
  expect(ask(cylinder(1, 0), line({0, 0.5, 5}, {0, 0, -1})), HitClass::hit, {{5, 1, {0, 0, -1}}});
  expect(ask(cylinder(1, 0), line({0, 1, 5}, {0, 0, -1})), HitClass::boundary, {{5, 0, {0, 1, 0}}});
  expect(ask(cylinder(1, 0), line({-3, 0, 0}, {1, 0, 0})), HitClass::boundary, {{2, 0, {-1, 0, 0}}, {4, 0, {1, 0, 0}}});
  expect(ask(cylinder(0, 4), line({0, 0, 5}, {0, 0, -1})), HitClass::boundary, {{3, 0, {0, 0, 1}}, {7, 0, {0, 0, 1}}});
  expect(ask(cylinder(0, 4), line({-3, 0, 1}, {1, 0, 0})), HitClass::tangent, {{3, 0, {0, 0, 1}}});
  expect(ask(cylinder(0, 0), line({-3, 0, -3}, {1, 0, 1})), HitClass::tangent, {{3, 0, {0, 0, 1}}});
}

TEST(SolidCone, BothNappesHaveFourCrossings) {
  // Slab [-2, 2], radius |z - 1|.
  const double n = ask(cone(4), line({0.5, 0, -5}, {0, 0, 1})).crossings.at(1).normal.x;
  EXPECT_NEAR(n, kHalfRoot, 0x1p-52);
  expect(ask(cone(4), line({0.5, 0, -5}, {0, 0, 1})), HitClass::hit,
         {{3, 1, {0, 0, -1}}, {5.5, 0, {n, 0, n}}, {6.5, 0, {n, 0, -n}}, {7, 2, {0, 0, 1}}});
  expect(ask(cone(4), {{0.5, 0, -5}, {0, 0, 1}, 6, kInfinity}), HitClass::hit,
         {{6.5, 0, {n, 0, -n}}, {7, 2, {0, 0, 1}}});
  EXPECT_TRUE(ask(cone(4), line({0.5, 0, 1.75}, {1, 0, 0})).inside);
  EXPECT_FALSE(ask(cone(4), line({0, 0, 1}, {1, 0, 0})).inside);
  EXPECT_EQ(ask(cone(4), line({0.5, 0, 1.25}, {0, 1, 0})).hit_class, HitClass::miss);
}

TEST(SolidCone, ThroughTheTip) {
  expect(ask(cone(4), line({0, 0, -5}, {0, 0, 1})), HitClass::hit, {{3, 1, {0, 0, -1}}, {7, 2, {0, 0, 1}}});
  expect(ask(cone(4), line({-1, 0, -3}, {1, 0, 4})), HitClass::hit, {{0.25, 1, {0, 0, -1}}, {1.25, 2, {0, 0, 1}}});
  expect(ask(cone(4), line({-3, 0, 1}, {1, 0, 0})), HitClass::tangent, {{3, 0, {0, 0, 1}}});
  // Along the side.
  const double n = ask(cone(4), line({-5, 0, -4}, {1, 0, 1})).crossings.at(0).normal.z;
  EXPECT_NEAR(n, kHalfRoot, 0x1p-52);
  EXPECT_EQ(ask(cone(4), line({-5, 0, -4}, {1, 0, 1})).hit_class, HitClass::boundary);
  expect(ask(cone(4), line({-5, 0, -4}, {1, 0, 1})), HitClass::boundary, {{2, 0, {-n, 0, n}}, {6, 0, {n, 0, -n}}});
  // The tip as the end of a single cone: from within the cone, and past it.
  expect(ask(cone(2), line({0, 0, 5}, {0, 0, -1})), HitClass::hit, {{4, 0, {0, 0, 1}}, {6, 1, {0, 0, -1}}});
  expect(ask(cone(2), line({-3, 0, 1}, {1, 0, 0})), HitClass::tangent, {{3, 0, {0, 0, 1}}});
  const Shape upside_down{.kind = ShapeKind::cone, .radius = 1, .height = 2, .tip_z = -1};
  expect(ask(upside_down, line({0, 0, 5}, {0, 0, -1})), HitClass::hit, {{4, 2, {0, 0, 1}}, {6, 0, {0, 0, -1}}});
}

TEST(SolidCone, ParallelToTheSideItHasOneRoot) {
  const ExactHit hit = ask(cone(4), line({-5, 0, -3.5}, {1, 0, 1}));
  EXPECT_EQ(hit.hit_class, HitClass::hit);
  ASSERT_EQ(hit.crossings.size(), 2U);
  EXPECT_EQ(hit.crossings[0].t_double, 4.75);
  EXPECT_EQ(hit.crossings[0].part, 0U);
  EXPECT_EQ(hit.crossings[1].t_double, 5.5);
  EXPECT_EQ(hit.crossings[1].part, 2U);
}

TEST(SolidHit, NormalsTakeTheInverseTranspose) {
  // M2: diag(2,1,1) takes the unit sphere's point (0.6, 0.8, 0), normal the same, to (1.2, 0.8, 0) with normal along
  // (0.3, 0.8, 0).
  const ExactHit hit = ask({sphere({}, 1), scaling({2, 1, 1})}, {{0, 0, 0}, {6, 4, 0}});
  ASSERT_EQ(hit.crossings.size(), 1U);
  EXPECT_EQ(hit.crossings[0].t_double, 0.2);
  const Normal3 n = hit.crossings[0].normal;
  EXPECT_LE(std::fabs(n.x - 3 / std::sqrt(73.0)), 0x1p-51);
  EXPECT_LE(std::fabs(n.y - 8 / std::sqrt(73.0)), 0x1p-51);
  // M3: outwards under a mirror as well.
  const ExactHit mirrored = ask({box({0, 0, 0}, {1, 1, 1}), scaling({1, 1, -1})}, line({0.5, 0.5, 5}, {0, 0, -1}));
  expect(mirrored, HitClass::hit, {{5, 4, {0, 0, 1}}, {6, 5, {0, 0, -1}}});
}

TEST(SolidHit, SingularMatricesAndNumbersOutsideOfTheDomain) {
  const Ray ray = line({0, 0, 5}, {0, 0, -1});
  EXPECT_EQ(ask({sphere({}, 1), scaling({1, 1, 0})}, ray).hit_class, HitClass::singular);
  EXPECT_EQ(
      ask({sphere({}, 1), AffineMatrix{{{0.1, 0.2, 0.3, 0}, {0.4, 0.5, 0.6, 0}, {0.1, 0.2, 0.3, 9}}}}, ray).hit_class,
      HitClass::singular);
  EXPECT_EQ(ask({sphere({}, 1), scaling({1, 1, 0x1p-1074})}, ray).hit_class, HitClass::hit);
  EXPECT_EQ(ask({sphere({}, 1), scaling({1, NAN, 0})}, ray).hit_class, HitClass::unsupported);
  EXPECT_EQ(ask(sphere({NAN, 0, 0}, 1), ray).hit_class, HitClass::unsupported);
  EXPECT_EQ(ask(sphere({}, -1), ray).hit_class, HitClass::unsupported);
  EXPECT_EQ(ask(sphere({}, kInfinity), ray).hit_class, HitClass::unsupported);
  EXPECT_EQ(ask(box({0, 1, 0}, {1, 0, 1}), ray).hit_class, HitClass::unsupported);
  EXPECT_EQ(ask(cylinder(1, -1), ray).hit_class, HitClass::unsupported);
  EXPECT_EQ(ask(Shape{.kind = ShapeKind::cone, .tip_z = 0}, ray).hit_class, HitClass::unsupported);
  EXPECT_EQ(ask(Shape{.kind = ShapeKind::triangle}, ray).hit_class, HitClass::unsupported);
  const Shape s = sphere({}, 1);
  EXPECT_EQ(ask(s, line({0, NAN, 0}, {0, 0, 1})).hit_class, HitClass::unsupported);
  EXPECT_EQ(ask(s, line({}, {0, -0.0, 0})).hit_class, HitClass::unsupported);
  EXPECT_EQ(ask(s, line({}, {0, kInfinity, 0})).hit_class, HitClass::unsupported);
  EXPECT_EQ(ask(s, {{}, {0, 0, 1}, 2, 1}).hit_class, HitClass::unsupported);
  EXPECT_EQ(ask(s, {{}, {0, 0, 1}, NAN, 1}).hit_class, HitClass::unsupported);
  EXPECT_EQ(ask(s, {{}, {0, 0, 1}, 0, NAN}).hit_class, HitClass::unsupported);
  // What a kind does not use is ignored.
  Shape odd = s;
  odd.height = odd.tip_z = odd.min.x = NAN;
  EXPECT_EQ(ask(odd, ray).hit_class, HitClass::hit);
}

TEST(SolidHit, TheEndsOfTheRangeOfDoubles) {
  // The side's coefficients lie far outside of what doubles hold; the answers are those of the same case scaled.
  for (const double scale : {0x1p-1000, 0x1p-500, 0x1p500, 0x1p1000}) {
    const ExactHit hit = ask(sphere({}, scale), line({0, 0, 5 * scale}, {0, 0, -scale}));
    EXPECT_EQ(hit.hit_class, HitClass::hit);
    ASSERT_EQ(hit.crossings.size(), 2U);
    EXPECT_EQ(hit.crossings[0].t_double, 4);
    EXPECT_EQ(hit.crossings[0].position, (Point3{0, 0, scale}));
    EXPECT_EQ(hit.crossings[0].normal, (Normal3{0, 0, 1}));
  }
  // t beyond the largest double.
  const ExactHit far = ask(box({0, 0, 0}, {1, 1, 1}), line({0.5, 0.5, -0x1p1000}, {0, 0, 0x1p-1000}));
  ASSERT_EQ(far.crossings.size(), 2U);
  EXPECT_EQ(far.crossings[0].t, (Enclosure{std::numeric_limits<double>::max(), kInfinity}));
  EXPECT_EQ(far.crossings[0].t_double, kInfinity);
  EXPECT_EQ(far.crossings[0].position, (Point3{0.5, 0.5, 0}));
  EXPECT_EQ(far.crossings[1].position, (Point3{0.5, 0.5, 1}));
}

TEST(SolidHit, CountsTheStageThatDecided) {
  StageCounters counters;
  const PlacedShape easy{sphere({}, 1), rotation_degrees({10, 20, 30})};
  solid_hit(easy, line({0.1, 0.2, 5}, {0.01, 0, -1}), ExactPath::filtered, counters);
  EXPECT_EQ(counters.filter, 1U);
  // The origin lies exactly on a face, but the products of 0.1 have more digits than a ball.
  const PlacedShape tie{box({0, 0, 0}, {1, 1, 1}), scaling({0.1, 0.1, 0.1})};
  const Ray from_face{{0.1, 0.05, 0.05}, {-1, 0, 0}};
  const ExactHit hit = solid_hit(tie, from_face, ExactPath::filtered, counters);
  ASSERT_EQ(hit.crossings.size(), 2U);
  EXPECT_EQ(hit.crossings[0].place, RangePlace::at_min);
  EXPECT_EQ(counters.filter, 1U);
  EXPECT_EQ(counters.expansion, 1U);
  solid_hit(tie, from_face, ExactPath::polynomial, counters);
  solid_hit(tie, from_face, ExactPath::rational, counters);
  EXPECT_EQ(counters.expansion, 2U);
  EXPECT_EQ(counters.rational, 1U);
}

TEST(SolidCrossingT, IsTheExactRoot) {
  const PlacedShape placed{sphere({}, 1)};
  const Ray ray = line({0.5, 0, 5}, {0, 0, -1});
  const ExactHit hit = ask(placed, ray);
  // t^2 - 10 t + 24.25, by a positive factor.
  for (int i = 0; i < 2; ++i) {
    const AlgebraicT t = solid_crossing_t(placed, ray, hit.crossings.at(static_cast<std::size_t>(i)));
    EXPECT_EQ(t.b, -10 * t.a);
    EXPECT_EQ(t.c, mpq_class(97, 4) * t.a);
    EXPECT_EQ(t.root, i);
  }
  const PlacedShape cube{box({0, 0, 0}, {3, 3, 3})};
  const Ray skew{{1, 1, -1}, {0.25, 0, 3}};
  const AlgebraicT t = solid_crossing_t(cube, skew, ask(cube, skew).crossings.at(0));
  EXPECT_EQ(t.a, 0);
  EXPECT_EQ(-t.c / t.b, mpq_class(1, 3));
  EXPECT_THROW(solid_crossing_t(cube, ray, hit.crossings[0]), std::invalid_argument);
}

TEST(SolidCrossingT, TellsRootsApartThatRoundAlike) {
  // Two spheres whose first crossings differ by less than an ulp of t.
  const Ray ray = line({0.5, 0, 0x1p30}, {0, 0, -1});
  const PlacedShape larger{sphere({}, 1)}, smaller{sphere({}, std::nextafter(1, 0))};
  const ExactHit a = ask(larger, ray), b = ask(smaller, ray);
  ASSERT_EQ(a.crossings.at(0).t, b.crossings.at(0).t);
  const AlgebraicT t = solid_crossing_t(larger, ray, a.crossings[0]);
  const AlgebraicT s = solid_crossing_t(smaller, ray, b.crossings[0]);
  // Monic, the same vertex; the larger sphere's constant is the smaller.
  EXPECT_EQ(t.b / t.a, s.b / s.a);
  EXPECT_LT(t.c / t.a, s.c / s.a);
}

}  // namespace
}  // namespace plumb
