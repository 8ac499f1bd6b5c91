#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "renderer/scene_for_tests.h"

namespace plumb {
namespace {

/// Tip at z = 3, radius 1 at z = 1, so radius (3 - z) / 2; from z = 0 (radius 1.5) to z = 2 (radius 0.5).
OneSurface single_cone() {
  return OneSurface(
      "<surface type='Cone'><center>0 0 1</center><tipz>3</tipz><radius>1</radius><height>2</height></surface>");
}

/// Tip at z = 0, radius |z|; from z = -3 to z = 1: both nappes.
OneSurface double_cone() {
  return OneSurface(
      "<surface type='Cone'><center>0 0 -1</center><tipz>0</tipz><radius>1</radius><height>4</height></surface>");
}

/// The crossings along a ray, each searched from just behind the one before.
std::vector<double> crossings(const OneSurface& surface, Ray ray) {
  std::vector<double> found;
  while (const auto hit = surface.hit(ray)) {
    found.push_back(hit->t);
    ray.t_min = std::nextafter(hit->t, hit->t + 1);
    if (found.size() > 8) break;
  }
  return found;
}

TEST(Cone, SideIsEnteredAndLeftWithItsOutwardNormal) {
  const Ray ray{{10, 0, 1}, {-1, 0, 0}};
  EXPECT_EQ(single_cone().hit(ray)->t, 9);
  // Perpendicular to the side from (1,0,1) to the tip (0,0,3), that is to (-1,0,2): (2,0,1) / sqrt 5.
  const Normal3 normal = single_cone().normal(ray);
  EXPECT_DOUBLE_EQ(normal.x, 2 / std::sqrt(5.0));
  EXPECT_DOUBLE_EQ(normal.z, 1 / std::sqrt(5.0));
  const Ray from_inside{{0, 0, 1}, {2, 0, 0}};
  EXPECT_EQ(single_cone().hit(from_inside)->t, 0.5);
  EXPECT_DOUBLE_EQ(single_cone().normal(from_inside).x, 2 / std::sqrt(5.0));
}

TEST(Cone, CapsAndSideSeenFromAboveAndBelow) {
  EXPECT_EQ(single_cone().hit({{0.25, 0, 10}, {0, 0, -1}})->t, 8) << "the cap at z = 2";
  EXPECT_EQ(single_cone().normal({{0.25, 0, 10}, {0, 0, -1}}), (Normal3{0, 0, 1}));
  EXPECT_DOUBLE_EQ(single_cone().hit({{0.75, 0, 10}, {0, 0, -1}})->t, 8.5) << "the side, radius 0.75 at z = 1.5";
  EXPECT_FALSE(single_cone().hit({{1.5000001, 0, 10}, {0, 0, -1}}));
  EXPECT_EQ(single_cone().hit({{1.25, 0, -10}, {0, 0, 1}})->t, 10) << "the cap at z = 0";
  EXPECT_EQ(single_cone().normal({{1.25, 0, -10}, {0, 0, 1}}), (Normal3{0, 0, -1}));
}

TEST(Cone, NappeBeyondTheSlabDoesNotShow) {
  EXPECT_FALSE(single_cone().hit({{10, 0, 4}, {-1, 0, 0}}));
  EXPECT_FALSE(single_cone().hit({{10, 0, 2.5}, {-1, 0, 0}}));
  EXPECT_FALSE(single_cone().hit({{10, 0, -0.5}, {-1, 0, 0}}));
}

TEST(Cone, DoubleConeHasFourCrossings) {
  // x = 0.5 going down: the cap z = 1 (radius 1), out at z = 0.5, in at z = -0.5, out through the cap z = -3.
  const std::vector<double> expected{9, 9.5, 10.5, 13};
  EXPECT_EQ(crossings(double_cone(), {{0.5, 0, 10}, {0, 0, -1}}), expected);
  const Ray leaving{{0.5, 0, 10}, {0, 0, -1}, 9.25, 20};
  const double root_half = std::sqrt(0.5);
  EXPECT_DOUBLE_EQ(double_cone().normal(leaving).x, root_half);
  EXPECT_DOUBLE_EQ(double_cone().normal(leaving).z, -root_half) << "the upper nappe's side looks down";
  const Ray entering{{0.5, 0, 10}, {0, 0, -1}, 10, 20};
  EXPECT_DOUBLE_EQ(double_cone().normal(entering).z, root_half);
}

TEST(Cone, BetweenTheNappesIsOutside) {
  EXPECT_FALSE(double_cone().hit({{0.5, 0, 0.25}, {0, 0, -1}, 0, 0.7}));
  EXPECT_EQ(double_cone().hit({{0.5, 0, 0.25}, {0, 0, -1}})->t, 0.75);
  EXPECT_EQ(double_cone().hit({{2, 0, 0.25}, {-1, 0, 0}})->t, 1.75);
}

TEST(Cone, RayParallelToTheSideHasOneRoot) {
  // (-3,0,-2) + t (1,0,1): |x| = |z| only at t = 2.5, the upper nappe's side at (-0.5,0,0.5); the cap z = 1 at t = 3.
  const std::vector<double> expected{2.5, 3};
  EXPECT_EQ(crossings(double_cone(), {{-3, 0, -2}, {1, 0, 1}}), expected);
}

TEST(Cone, RayThroughTheTipIsFinite) {
  const Ray across{{5, 0, 0}, {-1, 0, 0}};  // touches the tip alone; either answer would do, but a hit has a normal
  if (const auto hit = double_cone().hit(across)) {
    EXPECT_EQ(hit->t, 5);
    EXPECT_TRUE(is_finite(double_cone().normal(across)));
  }
  const std::vector<double> down = crossings(double_cone(), {{0, 0, 10}, {0, 0, -1}});
  EXPECT_EQ(down.front(), 9);
  EXPECT_EQ(down.back(), 13);
}

TEST(Cone, RangeIsClosedAtBothEnds) {
  const auto t = [](double from, double to) {
    const auto hit = double_cone().hit({{0.5, 0, 10}, {0, 0, -1}, from, to});
    return hit ? hit->t : -1;
  };
  EXPECT_EQ(t(9, 9), 9);
  EXPECT_EQ(t(9.5, 9.5), 9.5);
  EXPECT_EQ(t(10.5, 10.5), 10.5);
  EXPECT_EQ(t(9.6, 10.4), -1);
  EXPECT_EQ(t(10.6, 12.9), -1);
}

TEST(Cone, DirectionOfAnyLengthScalesT) { EXPECT_EQ(double_cone().hit({{0.5, 0, 10}, {0, 0, -4}})->t, 2.25); }

TEST(Cone, RayWithNanHitsNothing) {
  EXPECT_TRUE(double_cone().hit({{0.1, 0.2, 5}, {0, 0, -1}}));
  int rays = 0;
  for (const Ray& ray : rays_with_nan()) {
    EXPECT_FALSE(double_cone().hit(ray)) << rays;
    EXPECT_FALSE(single_cone().hit(ray)) << rays;
    ++rays;
  }
  EXPECT_EQ(rays, 8);
}

TEST(Cone, RandomRaysAgreeWithTheDefinition) {
  const OneSurface cone = double_cone();
  // Signed: negative inside. The same inequality as the solid's definition, x^2 + y^2 <= z^2 and -3 <= z <= 1.
  const auto outside = [](const Point3& p) {
    return std::max(std::hypot(p.x, p.y) - std::fabs(p.z), std::max(p.z - 1, -3 - p.z));
  };
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> u(-1, 1);
  int two = 0, four = 0, none = 0, tested = 0;
  for (int i = 0; i < 20000; ++i) {
    const Point3 from{4 * u(random), 4 * u(random), 5 * u(random)};
    const Point3 to{2 * u(random), 2 * u(random), -1 + 3 * u(random)};
    const Ray ray{from, to - from, -100, 100};
    const std::vector<double> ts = crossings(cone, ray);
    ASSERT_EQ(ts.size() % 2, 0u) << i;
    (ts.empty() ? none : ts.size() == 2 ? two : four) += 1;
    for (std::size_t k = 0; k < ts.size(); ++k) {
      // The direction is at most 15 long and the roots at most 100, where a unit of the last place is 1.4e-14; grazing
      // rays lose half of the digits of that.
      EXPECT_NEAR(outside(ray.at(ts[k])), 0, 1e-6) << i;
      if (k + 1 == ts.size() || ts[k + 1] - ts[k] < 1e-4) continue;
      const double middle = outside(ray.at(0.5 * (ts[k] + ts[k + 1])));
      EXPECT_EQ(middle < 0, k % 2 == 0) << "between crossings " << k << " and " << k + 1 << " of case " << i;
      ++tested;
    }
  }
  EXPECT_GT(none, 100);
  EXPECT_GT(two, 3000);
  EXPECT_GT(four, 300);
  EXPECT_GT(tested, 5000);
}

TEST(Cone, NothingEscapesThroughTheRim) {
  const OneSurface cone = single_cone();
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> u(-1, 1);
  int rays = 0;
  for (int i = 0; i < 100000; ++i) {
    const double angle = 3.14159 * u(random);
    const double radius = i % 2 ? 0.5 : 1.5;
    const Point3 rim{radius * std::cos(angle), radius * std::sin(angle), i % 2 ? 2.0 : 0.0};
    const Point3 inside{0.3 * u(random), 0.3 * u(random), 1 + 0.9 * u(random)};  // the radius is at least 0.55 here
    ASSERT_TRUE(cone.hit({inside, rim - inside})) << "from inside to the rim, case " << i;
    ASSERT_TRUE(cone.hit({rim + (rim - inside), inside - rim})) << "from outside through the rim, case " << i;
    ++rays;
  }
  EXPECT_EQ(rays, 100000);
}

}  // namespace
}  // namespace plumb
