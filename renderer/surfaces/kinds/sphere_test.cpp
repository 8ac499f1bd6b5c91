#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <sstream>

#include "renderer/scene_for_tests.h"

namespace plumb {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Centre (1,2,3), radius 2: on the line x = 1, y = 2 it reaches from z = 1 to z = 5.
OneSurface ball() { return OneSurface("<surface type='Sphere'><center>1 2 3</center><radius>2</radius></surface>"); }

TEST(Sphere, IsEnteredFromOutsideAndLeftFromInside) {
  const OneSurface sphere = ball();
  const Ray from_above{{1, 2, 10}, {0, 0, -1}};
  EXPECT_EQ(sphere.hit(from_above)->t, 5);  // 10 - 5
  EXPECT_EQ(sphere.normal(from_above), (Normal3{0, 0, 1}));
  const Ray from_center{{1, 2, 3}, {0, -1, 0}};
  EXPECT_EQ(sphere.hit(from_center)->t, 2);
  EXPECT_EQ(sphere.normal(from_center), (Normal3{0, -1, 0})) << "outward, along the ray";
}

TEST(Sphere, DirectionOfAnyLengthScalesT) {
  EXPECT_EQ(ball().hit({{1, 2, 10}, {0, 0, -4}})->t, 1.25);  // 5 / 4
  EXPECT_EQ(ball().hit({{1, 2, 10}, {0, 0, -0x1p-20}})->t, 5 * 0x1p20);
}

TEST(Sphere, TangentRayReportsOneHit) {
  // The line x = 3, y = 2 touches the sphere at (3,2,3); all numbers are exact, so the discriminant is 0.
  Ray ray{{3, 2, 10}, {0, 0, -1}};
  EXPECT_EQ(ball().hit(ray)->t, 7);
  EXPECT_EQ(ball().normal(ray), (Normal3{1, 0, 0}));
  ray.t_min = std::nextafter(7, 8);
  EXPECT_FALSE(ball().hit(ray));
}

TEST(Sphere, RayBesideOrBehindMisses) {
  EXPECT_FALSE(ball().hit({{std::nextafter(3, 4), 2, 10}, {0, 0, -1}}));
  EXPECT_FALSE(ball().hit({{1, 2, 10}, {0, 0, 1}}));
}

TEST(Sphere, RangeIsClosedAtBothEnds) {
  const Ray ray{{1, 2, 10}, {0, 0, -1}};  // crossings at 5 and 9
  const auto t = [&](double from, double to) {
    const auto hit = ball().hit({ray.origin, ray.direction, from, to});
    return hit ? hit->t : -1;
  };
  EXPECT_EQ(t(5, 5), 5);
  EXPECT_EQ(t(9, 9), 9);
  EXPECT_EQ(t(std::nextafter(5, 6), 9), 9);
  EXPECT_EQ(t(0, std::nextafter(5, 4)), -1);
  EXPECT_EQ(t(std::nextafter(9, 10), 100), -1);
  EXPECT_EQ(t(std::nextafter(5, 6), std::nextafter(9, 8)), -1) << "a range within the ball crosses nothing";
  EXPECT_FALSE(ball().blocks({ray.origin, ray.direction, 5.5, 8.5}));
  EXPECT_TRUE(ball().blocks({ray.origin, ray.direction, 5.5, 9}));
}

TEST(Sphere, OriginOnTheSurfaceIsARootAtZero) {
  EXPECT_EQ(ball().hit({{1, 2, 5}, {0, 0, -1}})->t, 0);
  EXPECT_EQ(ball().hit({{1, 2, 5}, {0, 0, 1}})->t, 0);
  EXPECT_EQ(ball().hit({{1, 2, 5}, {0, 0, -1}, 1e-6, kInfinity})->t, 4);
  EXPECT_FALSE(ball().hit({{1, 2, 5}, {0, 0, 1}, 1e-6, kInfinity}));
}

TEST(Sphere, FromAPointOnItTheRootHasTheSignOfTheExactOne) {
  // Points within a rounding of the surface lie in or out of it by the exact sign of |o - c|^2 - r^2, for which 113
  // bits do: numbers of 20 bits but for the origin's 53, so that each square is exact, and their sum but for 2^-110.
  __extension__ using Quad = __float128;
  std::mt19937_64 random(13);
  std::uniform_real_distribution<double> u(-1, 1);
  const auto few_bits = [&] { return std::round(0x1p16 * u(random)) * 0x1p-16; };
  int inside = 0, outside = 0, leaving = 0;
  for (int i = 0; i < 400; ++i) {
    const Point3 center{few_bits(), few_bits(), few_bits()};
    const double radius = 1 + std::fabs(few_bits());
    std::ostringstream element;
    element.precision(17);
    element << "<surface type='Sphere'><center>" << center.x << " " << center.y << " " << center.z
            << "</center><radius>" << radius << "</radius></surface>";
    const OneSurface sphere(element.str());
    for (int k = 0; k < 50; ++k) {
      const Vec3 out = normalized(Vec3{u(random), u(random), u(random)});
      const Ray ray{center + radius * out, Vec3{u(random), u(random), u(random)}};
      const Quad x = Quad(ray.origin.x) - center.x, y = Quad(ray.origin.y) - center.y,
                 z = Quad(ray.origin.z) - center.z;
      const Quad depth = x * x + y * y + z * z - Quad(radius) * radius;
      const double outward = dot(out, ray.direction);
      if (depth == 0 || std::fabs(outward) < 1e-6) continue;  // then a root at zero, or a near tangent
      const auto hit = sphere.hit(ray);
      if (depth > 0 && outward > 0) {
        EXPECT_FALSE(hit) << i << " " << k << ": outside and away";
        ++leaving;
      } else if (depth > 0) {
        ASSERT_TRUE(hit) << i << " " << k;
        EXPECT_LT(hit->t, 1e-8) << "just outside: the near root";
        ++outside;
      } else {
        ASSERT_TRUE(hit) << i << " " << k << ": no way out of the inside";
        EXPECT_GT(hit->t, 0);
        EXPECT_EQ(hit->t<1e-8, outward> 0) << "the root ahead, here or at the far side";
        ++inside;
      }
    }
  }
  EXPECT_GT(inside, 4000);
  EXPECT_GT(outside, 2000);
  EXPECT_GT(leaving, 2000);
}

TEST(Sphere, DirectionPerpendicularToTheCenterHasBothRoots) {
  // f = (1.2, 0, 0) from the centre, d = (0,1,0): t = +- sqrt(4 - 1.44) = +- 1.6, and the middle term is 0.
  const OneSurface sphere("<surface type='Sphere'><radius>2</radius></surface>");
  EXPECT_DOUBLE_EQ(sphere.hit({{1.2, 0, 0}, {0, 1, 0}})->t, 1.6);
  EXPECT_DOUBLE_EQ(sphere.hit({{1.2, 0, 0}, {0, 1, 0}, -10, 10})->t, -1.6);
}

TEST(Sphere, StaysAccurateFarAway) {
  const OneSurface sphere("<surface type='Sphere'/>");
  // At x = 0.6 the unit sphere has z = 0.8. With f.f - r^2 in the discriminant, all digits of r would be lost
  // from a distance of 2^27 on.
  for (const double distance : {1e3, 1e6, 1e9, 1e12}) {
    const auto hit = sphere.hit({{0.6, 0, distance}, {0, 0, -1}});
    ASSERT_TRUE(hit) << distance;
    // The roots come from f.d, f.f and a square root beside a far larger number: a few units of the last place of t.
    EXPECT_NEAR(hit->t, distance - 0.8, 4 * 0x1p-52 * distance);
    EXPECT_FALSE(sphere.hit({{1.0000001, 0, distance}, {0, 0, -1}})) << distance;
    EXPECT_TRUE(sphere.hit({{0.9999999, 0, distance}, {0, 0, -1}})) << distance;
  }
}

TEST(Sphere, OfRadiusZeroIsAPoint) {
  const OneSurface point("<surface type='Sphere'><radius>0</radius></surface>");
  EXPECT_EQ(point.hit({{0, 0, 5}, {0, 0, -1}})->t, 5);
  EXPECT_FALSE(point.hit({{1e-9, 0, 5}, {0, 0, -1}}));
}

TEST(Sphere, RayWithNanHitsNothing) {
  const OneSurface sphere("<surface type='Sphere'/>");
  EXPECT_TRUE(sphere.hit({{0.1, 0.2, 5}, {0, 0, -1}}));
  int rays = 0;
  for (const Ray& ray : rays_with_nan()) {
    EXPECT_FALSE(sphere.hit(ray)) << rays;
    ++rays;
  }
  EXPECT_EQ(rays, 8);
}

TEST(Sphere, RandomRaysAgreeWithTheDistanceOfTheCenter) {
  const OneSurface sphere("<surface type='Sphere'><center>.5 -.25 .125</center><radius>.75</radius></surface>");
  const Point3 center{0.5, -0.25, 0.125};
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> u(-1, 1);
  int hits = 0, misses = 0;
  for (int i = 0; i < 20000; ++i) {
    const Ray ray{
        {3 * u(random), 3 * u(random), 3 * u(random)}, {u(random), u(random), u(random)}, -kInfinity, kInfinity};
    const Vec3 to_center = center - ray.origin;
    const double distance = length(cross(to_center, ray.direction)) / length(ray.direction);
    if (std::fabs(distance - 0.75) < 1e-9) continue;  // the class is free on the rim, as far as this formula rounds
    const auto hit = sphere.hit(ray);
    ASSERT_EQ(hit.has_value(), distance < 0.75) << i;
    if (!hit) {
      ++misses;
      continue;
    }
    ++hits;
    // t has a relative error of a few 2^-53 / cos of the angle at the surface; the filter keeps that cosine above 5e-5.
    EXPECT_NEAR(length(ray.at(hit->t) - center), 0.75, 1e-10) << i;
    EXPECT_LE(hit->t, dot(to_center, ray.direction) / dot(ray.direction, ray.direction)) << "the nearer root";
  }
  EXPECT_GT(hits, 1000);
  EXPECT_GT(misses, 3000);
}

}  // namespace
}  // namespace plumb
