#include "renderer/surfaces/triangle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "meshes/generators/icosphere.h"

namespace plumb {
namespace {

std::optional<TriangleHit> triangle_hit(const Ray& ray, const Point3& a, const Point3& b, const Point3& c) {
  return intersect_triangle(ShearedRay(ray), a, b, c);
}

constexpr Point3 kA{0, 0, 0}, kB{1, 0, 0}, kC{0, 1, 0};

TEST(Triangle, IsHitFromBothSidesInEitherOrientation) {
  for (const double side : {-1.0, 1.0}) {
    const Ray ray{{0.25, 0.5, 4 * side}, {0, 0, -2 * side}};
    const auto hit = triangle_hit(ray, kA, kB, kC);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->t, 2);  // 4 / 2
    EXPECT_EQ(hit->u, 0.25);
    EXPECT_EQ(hit->v, 0.5);
    const auto turned = triangle_hit(ray, kA, kC, kB);
    ASSERT_TRUE(turned);
    EXPECT_EQ(turned->t, 2);
    EXPECT_EQ(turned->u, 0.5);
    EXPECT_EQ(turned->v, 0.25);
  }
}

TEST(Triangle, EdgesAndVerticesBelongToIt) {
  int hits = 0;
  for (const Point3& target : {kA, kB, kC, Point3{0.5, 0, 0}, Point3{0, 0.5, 0}, Point3{0.5, 0.5, 0}}) {
    const auto hit = triangle_hit({{target.x, target.y, 1}, {0, 0, -1}}, kA, kB, kC);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->u, target.x);
    EXPECT_EQ(hit->v, target.y);
    ++hits;
  }
  EXPECT_EQ(hits, 6);
}

TEST(Triangle, JustBesideAnEdgeIsAMiss) {
  EXPECT_FALSE(triangle_hit({{-0x1p-30, 0.5, 1}, {0, 0, -1}}, kA, kB, kC));
  EXPECT_FALSE(triangle_hit({{0.5, -0x1p-30, 1}, {0, 0, -1}}, kA, kB, kC));
  EXPECT_FALSE(triangle_hit({{0.5, 0.5 + 0x1p-30, 1}, {0, 0, -1}}, kA, kB, kC));
}

TEST(Triangle, RangeIsClosedAtBothEnds) {
  const auto hit = [](double from, double to) {
    return triangle_hit({{0.25, 0.25, 4}, {0, 0, -1}, from, to}, kA, kB, kC).has_value();
  };
  EXPECT_TRUE(hit(4, 4));
  EXPECT_FALSE(hit(std::nextafter(4, 5), 10));
  EXPECT_FALSE(hit(0, std::nextafter(4, 3)));
  EXPECT_FALSE(triangle_hit({{0.25, 0.25, 4}, {0, 0, 1}}, kA, kB, kC)) << "behind";
  EXPECT_EQ(triangle_hit({{0.25, 0.25, 0}, {0, 0, 1}}, kA, kB, kC)->t, 0) << "origin on it";
}

TEST(Triangle, RaysInItsPlaneMiss) {
  EXPECT_FALSE(triangle_hit({{-1, 0.25, 0}, {1, 0, 0}}, kA, kB, kC));
  EXPECT_FALSE(triangle_hit({{-1, 0, 0}, {1, 0, 0}}, kA, kB, kC)) << "along an edge";
  EXPECT_FALSE(triangle_hit({{-1, 0.25, 1}, {1, 0, 0}}, kA, kB, kC)) << "parallel to it";
}

TEST(Triangle, WithoutAreaIsMissed) {
  EXPECT_FALSE(triangle_hit({{0.5, 0, 1}, {0, 0, -1}}, kA, kB, kB));
  EXPECT_FALSE(triangle_hit({{0.5, 0, 1}, {0, 0, -1}}, kA, kB, {2, 0, 0}));
  EXPECT_FALSE(triangle_hit({{0, 0, 1}, {0, 0, -1}}, kA, kA, kA));
}

TEST(Triangle, RayWithNanHitsNothing) {
  const double nan = std::nan("");
  const Point3 o{0.25, 0.25, 1};
  const Vec3 d{0, 0, -1};
  EXPECT_TRUE(triangle_hit({o, d}, kA, kB, kC));
  for (int axis = 0; axis < 3; ++axis) {
    Ray ray{o, d};
    ray.origin[axis] = nan;
    EXPECT_FALSE(triangle_hit(ray, kA, kB, kC));
    ray = {o, d};
    ray.direction[axis] = nan;
    EXPECT_FALSE(triangle_hit(ray, kA, kB, kC));
  }
  EXPECT_FALSE(triangle_hit({o, d, nan, 10}, kA, kB, kC));
  EXPECT_FALSE(triangle_hit({o, d, 0, nan}, kA, kB, kC));
}

TEST(Triangle, TinyAndHugeOnesAreHit) {
  for (const double scale : {1e-30, 1e-8, 1e8, 1e30}) {
    const Ray ray{{0.25 * scale, 0.25 * scale, scale}, {0, 0, -1}};
    const auto hit = triangle_hit(ray, kA, {scale, 0, 0}, {0, scale, 0});
    ASSERT_TRUE(hit) << scale;
    EXPECT_DOUBLE_EQ(hit->t, scale);
  }
}

TEST(Triangle, HasTheClassOfTheRayAsGivenBesideItsEdges) {
  // Vertices and origins of 24 bits, so that 113 bits hold the differences and their products but for the last few, and
  // directions of all 53 bits towards an edge: each triple product d . (p x q) is off by 2^-110 of its terms.
  __extension__ using Quad = __float128;
  std::mt19937_64 random(19);
  std::uniform_real_distribution<double> u(-1, 1);
  const auto point = [&] {
    const auto few_bits = [&] { return static_cast<double>(static_cast<float>(u(random))); };
    return Point3{few_bits(), few_bits(), few_bits()};
  };
  const auto triple = [](const Vec3& d, const Vec3& p, const Vec3& q) {
    return d.x * (Quad(p.y) * q.z - Quad(p.z) * q.y) + d.y * (Quad(p.z) * q.x - Quad(p.x) * q.z) +
           d.z * (Quad(p.x) * q.y - Quad(p.y) * q.x);
  };
  int hits = 0, misses = 0, undecided = 0;
  for (int i = 0; i < 100000; ++i) {
    const Point3 a = point(), b = point(), c = point();
    Ray ray{point(), {}, -std::numeric_limits<double>::infinity()};
    ray.direction = a + 0.5 * (1 + u(random)) * (b - a) - ray.origin;
    const Vec3 to_a = a - ray.origin, to_b = b - ray.origin, to_c = c - ray.origin;  // exact
    const Quad weights[] = {triple(ray.direction, to_c, to_b), triple(ray.direction, to_a, to_c),
                            triple(ray.direction, to_b, to_a)};
    bool positive = false, negative = false, sure = true;
    for (const Quad weight : weights) {
      sure = sure && (weight > 0x1p-100 || weight < -0x1p-100);
      positive = positive || weight > 0;
      negative = negative || weight < 0;
    }
    if (!sure) {
      ++undecided;
      continue;
    }
    ASSERT_EQ(triangle_hit(ray, a, b, c).has_value(), positive != negative) << i;
    ++(positive != negative ? hits : misses);
  }
  EXPECT_GT(hits, 40000);
  EXPECT_GT(misses, 40000);
  EXPECT_LT(undecided, 10);
}

TEST(Triangle, GrazingHitsLieWithinItsBox) {
  // At angles of 1e-16 to 1e-3 to the plane, where a t from rounded products may be anything.
  std::mt19937_64 random(23);
  std::uniform_real_distribution<double> u(-1, 1);
  const auto vector = [&] { return Vec3{u(random), u(random), u(random)}; };
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    const Point3 a = Point3{} + vector(), b = Point3{} + vector(), c = Point3{} + vector();
    const Vec3 normal = normalized(cross(b - a, c - a));
    const Point3 target = a + 0.25 * (1 + u(random)) * (b - a) + 0.25 * (1 + u(random)) * (c - a);
    const Vec3 along = normalized(b - target) + std::pow(10, -9.5 + 6.5 * u(random)) * normal;
    const Ray ray{target + -2.0 * along, along};
    const auto hit = triangle_hit(ray, a, b, c);
    if (!hit) continue;
    ++hits;
    Bounds3 box;
    for (const Point3& p : {a, b, c}) box.extend(p);
    const Point3 at = ray.at(hit->t);
    for (int axis = 0; axis < 3; ++axis) {
      // The point is rounded three times at a size of at most 6.
      EXPECT_GE(at[axis], box.min[axis] - 4 * 6 * 0x1p-53) << i;
      EXPECT_LE(at[axis], box.max[axis] + 4 * 6 * 0x1p-53) << i;
    }
  }
  EXPECT_GT(hits, 2000);
}

/// The number of triangles of the mesh that the ray meets.
int hits_of(const TriangleMesh& mesh, const Ray& ray) {
  int hits = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    hits += triangle_hit(ray, mesh.positions[a], mesh.positions[b], mesh.positions[c]).has_value();
  return hits;
}

TEST(Triangle, NothingLeaksThroughTheEdgesAndVerticesOfAClosedMesh) {
  // Edges and vertices, on doubles that use all of their 53 bits.
  const TriangleMesh mesh = icosphere(2);
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> u(-1, 1);
  std::uniform_int_distribution<std::size_t> any_triangle(0, mesh.triangles.size() - 1);
  int from_inside = 0, from_outside = 0, several = 0;
  for (int i = 0; from_inside < 50000 || from_outside < 50000; ++i) {
    const auto& triangle = mesh.triangles[any_triangle(random)];
    const Point3 a = mesh.positions[triangle[0]];
    const Point3 b = mesh.positions[triangle[1]];
    const Point3 target = i % 2 ? a : a + 0.5 * (1 + u(random)) * (b - a);
    const Point3 inside{0.4 * u(random), 0.4 * u(random), 0.4 * u(random)};
    const int out = hits_of(mesh, {inside, target - inside});
    ASSERT_GE(out, 1) << "leak from inside, case " << i;
    several += out > 1;
    ++from_inside;
    // From outside, where the target looks at the origin by far: the sphere's horizon from 3 away is at cosine 1/3.
    const Vec3 where = normalized(Vec3{u(random), u(random), u(random)});
    if (!(dot(where, target - Point3{}) > 0.5)) continue;
    ASSERT_GE(hits_of(mesh, {Point3{} + 3 * where, target - (Point3{} + 3 * where)}), 1)
        << "leak from outside, case " << i;
    ++from_outside;
  }
  EXPECT_GE(from_inside, 50000);
  EXPECT_GE(from_outside, 50000);
  EXPECT_GT(several, 1000) << "the rays really met edges";
}

// docs/certified-kernel.md: whatever stage it comes from, t is off by 2^-40 of the way at most (2^-41 and the
// rounding).
TEST(Triangle, TIsCloseHoweverFlatlyThePlaneIsMet) {
  std::mt19937_64 random(18);
  std::uniform_real_distribution<double> u(-1, 1);
  const auto vector = [&] {
    const double x = u(random), y = u(random);
    return Vec3{x, y, u(random)};
  };
  int met = 0, too_wide = 0, wrong = 0;
  double largest = 0;
  for (int i = 0; i < 60000; ++i) {
    const Point3 a = Point3{} + vector(), b = Point3{} + vector(), c = Point3{} + vector();
    const Point3 target = a + (0.25 * (b - a) + 0.25 * (c - a));
    const Vec3 way = u(random) * (b - a) + u(random) * (c - a) + std::ldexp(1.0, -i % 50) * vector();
    const Ray ray{target + -1.0 * way, way};
    const ShearedRay sheared(ray);
    TriangleMeeting meeting;
    if (!meet(sheared, ShearedTriangle(sheared, a, b, c), a, b, c, meeting)) continue;
    ++met;
    const double off = std::fabs(meeting.t - ExactTriangle(ray, nullptr, {a, b, c}).t());
    const double size = largest_coordinate(a - ray.origin) / largest_coordinate(way) + std::fabs(meeting.t);
    largest = std::max(largest, off / size);
    wrong += off > meeting.t_error;
    too_wide += meeting.t_error > 0x1p-40 * size;
  }
  EXPECT_GT(met, 50000);
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(too_wide, 0);
  EXPECT_LE(largest, 0x1p-41);
}

}  // namespace
}  // namespace plumb
