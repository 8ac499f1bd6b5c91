#include "renderer/accel/hierarchy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "renderer/scene_for_tests.h"
#include "renderer/surfaces/closest_triangle.h"

namespace plumb {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Soup {
  std::vector<std::array<Point3, 3>> triangles;

  std::vector<Bounds3> bounds() const {
    std::vector<Bounds3> all(triangles.size());
    for (std::size_t i = 0; i < all.size(); ++i)
      for (const Point3& p : triangles[i]) all[i].extend(p);
    return all;
  }

  TriangleMesh mesh() const {
    TriangleMesh result;
    for (const auto& triangle : triangles) {
      const auto first = static_cast<std::uint32_t>(result.positions.size());
      result.positions.insert(result.positions.end(), triangle.begin(), triangle.end());
      result.triangles.push_back({first, first + 1, first + 2});
    }
    return result;
  }
};

/// The closest hit, as Mesh looks for it.
std::optional<SurfaceHit> closest(const TriangleMesh& mesh, double largest, const Accelerator& accelerator,
                                  const Ray& ray) {
  const PlacedRay placed(ray);
  ClosestTriangle found(placed, mesh, largest);
  Ray rest = ray;
  TraceCounters counters;
  accelerator.walk(rest, counters, [&](std::uint32_t i) {
    found.offer(i);
    rest.t_max = found.t_max();
    return false;
  });
  return found.result();
}

bool same_hit(const std::optional<SurfaceHit>& a, const std::optional<SurfaceHit>& b) {
  if (!a || !b) return !a && !b;
  return a->part == b->part && same_bits(a->t, b->t) && same_bits(a->u, b->u) && same_bits(a->v, b->v);
}

struct Agreement {
  int hits = 0, misses = 0, different = 0;
};

Agreement compare(const Soup& soup, const std::vector<Ray>& rays) {
  const std::vector<Bounds3> bounds = soup.bounds();
  const TriangleMesh mesh = soup.mesh();
  double largest = 0;
  for (const Bounds3& box : bounds) largest = std::max(largest, largest_coordinate(box));
  const Accelerator linear(Accel::linear, bounds);
  const Accelerator bvh2(Accel::bvh2, bounds);
  Agreement agreement;
  for (const Ray& ray : rays) {
    const auto a = closest(mesh, largest, linear, ray);
    const auto b = closest(mesh, largest, bvh2, ray);
    ++(a ? agreement.hits : agreement.misses);
    if (same_hit(a, b)) continue;
    if (++agreement.different == 1) {
      ADD_FAILURE() << std::hexfloat << "first differing ray: origin " << ray.origin.x << " " << ray.origin.y << " "
                    << ray.origin.z << " direction " << ray.direction.x << " " << ray.direction.y << " "
                    << ray.direction.z << ", linear " << (a ? a->part : ~0U) << " at " << (a ? a->t : 0)
                    << ", hierarchy " << (b ? b->part : ~0U) << " at " << (b ? b->t : 0);
    }
  }
  EXPECT_EQ(agreement.different, 0);
  return agreement;
}

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double operator()() { return uniform_(engine_); }
  Point3 point(double scale) { return {scale * (*this)(), scale * (*this)(), scale * (*this)()}; }

 private:
  std::mt19937_64 engine_;
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

Soup random_soup(Random& u, int count, double size) {
  Soup soup;
  for (int i = 0; i < count; ++i) {
    const Point3 a = u.point(1);
    soup.triangles.push_back({a, a + size * (u.point(1) - Point3{}), a + size * (u.point(1) - Point3{})});
  }
  return soup;
}

std::vector<Ray> random_rays(Random& u, int count, double distance) {
  std::vector<Ray> rays;
  for (int i = 0; i < count; ++i) {
    const Point3 from = u.point(distance);
    rays.push_back({from, u.point(1) - from});
  }
  return rays;
}

TEST(Hierarchy, FindsTheSameHitsAsLinearSearchInRandomSoups) {
  Random u(1);
  int soups = 0;
  Agreement sum;
  for (const int count : {1, 2, 3, 17, 100, 1000}) {
    for (const double size : {0.01, 0.2, 2.0}) {
      const Soup soup = random_soup(u, count, size);
      const Agreement agreement = compare(soup, random_rays(u, 1000, 3));
      sum.hits += agreement.hits;
      sum.misses += agreement.misses;
      ++soups;
    }
  }
  EXPECT_EQ(soups, 18);
  EXPECT_GT(sum.hits, 4000);
  EXPECT_GT(sum.misses, 4000);
}

/// The surface of the cube [low, low + n]^3 out of unit squares, two triangles each.
Soup lattice_cube(int low, int n) {
  Soup soup;
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {0, n}) {
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          const auto corner = [&](int di, int dj) {
            Point3 p;
            p[axis] = low + side;
            p[(axis + 1) % 3] = low + i + di;
            p[(axis + 2) % 3] = low + j + dj;
            return p;
          };
          soup.triangles.push_back({corner(0, 0), corner(1, 0), corner(1, 1)});
          soup.triangles.push_back({corner(0, 0), corner(1, 1), corner(0, 1)});
        }
      }
    }
  }
  return soup;
}

/// From inside to vertices, middles of edges and along the axes.
std::vector<Ray> lattice_rays(const Soup& soup, Random& u, const Point3& center, double reach) {
  std::vector<Ray> rays;
  for (int round = 0; round < 10; ++round) {
    for (const auto& [a, b, c] : soup.triangles) {
      const Point3 from = center + reach * (u.point(1) - Point3{});
      rays.push_back({from, a - from});
      rays.push_back({from, a + 0.5 * (b - a) - from});
      rays.push_back(
          {{std::round(from.x), from.y, std::round(from.z)}, {0, round % 2 ? 1.0 : -1.0, round % 3 ? 0.0 : -0.0}});
    }
  }
  return rays;
}

TEST(Hierarchy, FindsTheSameHitsAsLinearSearchOnALatticeCube) {
  Random u(2);
  const Soup soup = lattice_cube(1, 8);
  const Agreement agreement = compare(soup, lattice_rays(soup, u, {5, 5, 5}, 3));
  EXPECT_GT(agreement.hits, 22000);
}

TEST(Hierarchy, FindsTheSameHitsAsLinearSearchOnALatticeCubeAroundZero) {
  // A face in the plane x = 0 has a box that no relative margin widens.
  Random u(3);
  for (const int low : {0, -4}) {
    const Soup soup = lattice_cube(low, 8);
    const Point3 center{low + 4.0, low + 4.0, low + 4.0};
    EXPECT_GT(compare(soup, lattice_rays(soup, u, center, 3)).hits, 22000);
  }
}

TEST(Hierarchy, FindsTheSameHitsInDegenerateSoups) {
  Random u(6);
  Soup one_center, points, huge_spread;
  for (int i = 0; i < 300; ++i) {
    const Vec3 a = u.point(1) - Point3{}, b = u.point(1) - Point3{};
    const Vec3 c = -(a + b);
    one_center.triangles.push_back({Point3{} + a, Point3{} + b, Point3{} + c});
    const Point3 p = u.point(1);
    points.triangles.push_back({p, p, p});
    const double size = std::pow(10.0, 10 * u());
    huge_spread.triangles.push_back(
        {Point3{} + size * a, Point3{} + size * b, Point3{} + size * (u.point(1) - Point3{})});
  }
  points.triangles.push_back({Point3{-3, -3, 0.5}, Point3{3, -3, 0.5}, Point3{0, 3, 0.5}});
  EXPECT_GT(compare(one_center, random_rays(u, 1000, 3)).hits, 100);
  EXPECT_GT(compare(points, random_rays(u, 1000, 3)).hits, 100);
  EXPECT_GT(compare(huge_spread, random_rays(u, 1000, 3)).hits, 100);
}

TEST(Hierarchy, OfNothingVisitsNothing) {
  TraceCounters counters;
  const auto fail = [](std::uint32_t) -> bool { throw std::logic_error("visited"); };
  const Ray ray{{0, 0, 0}, {0, 0, 1}};
  EXPECT_FALSE(Hierarchy({}).walk(ray, counters, fail));
  const std::vector<Bounds3> empty(5);
  EXPECT_FALSE(Hierarchy(empty).walk(ray, counters, fail)) << "empty boxes are never visited";
  EXPECT_EQ(Hierarchy(empty).node_count(), 0u);
}

TEST(Hierarchy, StopsWhenToldTo) {
  const std::vector<Bounds3> boxes(100, Bounds3{{-1, -1, 1}, {1, 1, 2}});
  TraceCounters counters;
  int visits = 0;
  EXPECT_TRUE(Hierarchy(boxes).walk({{0, 0, 0}, {0, 0, 1}}, counters, [&](std::uint32_t) { return ++visits == 7; }));
  EXPECT_EQ(visits, 7);
  visits = 0;
  EXPECT_FALSE(Hierarchy(boxes).walk({{0, 0, 0}, {0, 0, 1}}, counters, [&](std::uint32_t) { return ++visits == 101; }));
  EXPECT_EQ(visits, 100);
}

TEST(Hierarchy, IsNotDeeperThanItsStack) {
  // Sizes and places that grow by 10 each make every split by area peel off a single box.
  std::vector<Bounds3> boxes;
  for (int i = 0; i < 600; ++i) {
    const double x = std::pow(10.0, -300 + i);
    boxes.push_back({{x, 0, 0}, {2 * x, 1, 1}});
  }
  const Hierarchy hierarchy(boxes);
  EXPECT_GT(hierarchy.depth(), 20) << "this is meant to be a deep one";
  EXPECT_LE(static_cast<std::size_t>(hierarchy.depth()), Hierarchy::kDeepest);
  TraceCounters counters;
  std::vector<int> visits(boxes.size());
  hierarchy.walk({{0, 0.5, 0.5}, {1, 0, 0}}, counters, [&](std::uint32_t i) { return ++visits[i] == 2; });
  EXPECT_EQ(std::count(visits.begin(), visits.end(), 1), 600);
}

TEST(SlabTest, RayWithinAFaceIsNoFalseMiss) {
  const Bounds3 box{{-1, -2, -3}, {1, 2, 3}};
  int cases = 0;
  for (const double zero : {0.0, -0.0}) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const double side : {-1.0, 1.0}) {
        Ray ray{{0, 0, 0}, {zero, zero, zero}};
        ray.origin[(axis + 1) % 3] = side * box.max[(axis + 1) % 3];  // in a face
        ray.origin[axis] = -10;
        ray.direction[axis] = 1;
        EXPECT_TRUE(SlabTest(ray).may_hit(box, 0, kInfinity)) << cases;
        ray.origin[(axis + 2) % 3] = side * box.max[(axis + 2) % 3];  // along an edge
        EXPECT_TRUE(SlabTest(ray).may_hit(box, 0, kInfinity)) << cases;
        EXPECT_FALSE(SlabTest(ray).may_hit(box, 0, 1)) << "not within the range";
        ray.origin[(axis + 2) % 3] *= 1.001;
        EXPECT_FALSE(SlabTest(ray).may_hit(box, 0, kInfinity)) << "beside it";
        ++cases;
      }
    }
  }
  EXPECT_EQ(cases, 12);
}

TEST(Hierarchy, FindsTheSameHitsFromFarAway) {
  Random u(5);
  const Soup soup = random_soup(u, 300, 0.5);
  int hits = 0;
  for (const double distance : {1e3, 1e5, 1e7}) hits += compare(soup, random_rays(u, 2000, distance)).hits;
  EXPECT_GT(hits, 3000);
}

TEST(Hierarchy, FindsTheSameHitsInOnePlane) {
  // Large triangles in the plane z = 0 overlap, so that every ray has many hits within a few units of the last place.
  Random u(4);
  Soup soup = random_soup(u, 200, 1);
  for (auto& triangle : soup.triangles)
    for (Point3& p : triangle) p.z = 0;
  std::vector<Ray> rays;
  for (int i = 0; i < 5000; ++i) {
    const Point3 from{u(), u(), 3 + u()};
    rays.push_back({from, (1.5 + u()) * (Point3{0.5 * u(), 0.5 * u(), 0} - from)});  // t is no simple number
  }
  EXPECT_GT(compare(soup, rays).hits, 4500);
}

}  // namespace
}  // namespace plumb
