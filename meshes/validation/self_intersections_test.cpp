#include "meshes/validation/self_intersections.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

#include "meshes/validation/mesh_places.h"
#include "meshes/validation/meshes_for_tests.h"

namespace plumb {
namespace {

/// A rational number. Coordinates of the soups are small, and so are the determinants that all of these are quotients
/// of: below 2^31, so that nothing overflows.
struct Fraction {
  std::int64_t over = 0, under = 1;

  Fraction(std::int64_t whole = 0) : over(whole) {}
  Fraction(std::int64_t top, std::int64_t bottom) {
    const std::int64_t divisor = std::gcd(top, bottom) * (bottom < 0 ? -1 : 1);
    over = top / divisor, under = bottom / divisor;
  }
  int sign() const { return (over > 0) - (over < 0); }
  friend Fraction operator+(Fraction a, Fraction b) { return {a.over * b.under + b.over * a.under, a.under * b.under}; }
  friend Fraction operator-(Fraction a, Fraction b) { return a + Fraction(-b.over, b.under); }
  friend Fraction operator*(Fraction a, Fraction b) { return {a.over * b.over, a.under * b.under}; }
  friend Fraction operator/(Fraction a, Fraction b) { return a * Fraction(b.under, b.over); }
  friend bool operator==(Fraction, Fraction) = default;
};

using Vector = std::array<Fraction, 3>;
Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Fraction dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
bool is_zero(const Vector& v) { return v == Vector{}; }

using Polygon = std::vector<Vector>;

/// The part of a convex polygon, or segment or point, where normal . (p - origin) >= 0.
Polygon clipped(const Polygon& polygon, const Vector& normal, const Vector& origin) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const Fraction at_p = dot(normal, p - origin), at_q = dot(normal, q - origin);
    if (at_p.sign() >= 0) kept.push_back(p);
    if (at_p.sign() * at_q.sign() >= 0) continue;
    const Fraction share = at_p / (at_p - at_q);
    kept.push_back({p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1]), p[2] + share * (q[2] - p[2])});
  }
  return kept;
}

/// The corners of what two triangles have in common: the first, cut by the plane of the second from both sides and by
/// the planes that stand on its edges.
Polygon common_part(const Polygon& a, const Polygon& b) {
  const Vector normal = cross(b[1] - b[0], b[2] - b[0]);
  Polygon part = clipped(a, normal, b[0]);
  part = clipped(part, Vector{} - normal, b[0]);
  for (std::size_t i = 0; i < 3; ++i) part = clipped(part, cross(normal, b[(i + 1) % 3] - b[i]), b[i]);
  return part;
}

/// By the definition: whether the common part holds more than what is shared.
bool intersect_slowly(const Polygon& a, const Polygon& b) {
  Polygon shared;
  std::ranges::copy_if(a, std::back_inserter(shared), [&](const Vector& p) { return std::ranges::count(b, p) > 0; });
  const Polygon part = common_part(a, b);
  return std::ranges::any_of(part, [&](const Vector& p) {
    if (shared.empty() || shared.size() == 3) return true;
    if (shared.size() == 1) return p != shared[0];
    return !is_zero(cross(shared[1] - shared[0], p - shared[0]));
  });
}

MeshFault slow_self_intersections(const TriangleMesh& mesh) {
  std::vector<Polygon> polygons;
  for (const auto& triangle : mesh.triangles) {
    Polygon& polygon = polygons.emplace_back();
    for (const std::uint32_t vertex : triangle) {
      const Point3& p = mesh.positions[vertex];
      polygon.push_back({std::int64_t(p.x), std::int64_t(p.y), std::int64_t(p.z)});
    }
  }
  const auto has_area = [](const Polygon& p) { return !is_zero(cross(p[1] - p[0], p[2] - p[0])); };
  MeshFault fault;
  for (std::uint32_t i = 0; i < polygons.size(); ++i) {
    const auto meets = [&](const Polygon& other) {
      return &other != &polygons[i] && has_area(other) && intersect_slowly(polygons[i], other);
    };
    if (has_area(polygons[i]) && std::ranges::any_of(polygons, meets)) fault.add(i);
  }
  return fault;
}

MeshFault fast_self_intersections(const TriangleMesh& mesh) {
  return self_intersections(mesh, mesh_places(mesh).place_of, {});
}

/// Few places and triangles drawn from them, so that every way to share and to touch comes up; many coincide.
TriangleMesh soup(std::mt19937_64& random, int side, std::uint32_t vertices, std::size_t triangles) {
  const auto below = [&](std::uint64_t n) { return static_cast<std::uint32_t>(random() % n); };
  TriangleMesh mesh;
  const auto coordinate = [&] { return static_cast<double>(below(static_cast<std::uint64_t>(side))); };
  for (std::uint32_t i = 0; i < vertices; ++i) {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    mesh.positions.push_back({x, y, z});
  }
  for (std::size_t i = 0; i < triangles; ++i) {
    const std::uint32_t a = below(vertices), b = below(vertices), c = below(vertices);
    mesh.triangles.push_back({a, b, c});
  }
  return mesh;
}

TEST(SelfIntersections, AgreeWithExactClipping) {
  std::mt19937_64 random(5);
  int soups = 0, free_soups = 0;
  std::uint64_t triangles = 0, intersecting = 0;
  for (const auto& [side, vertices, count] :
       {std::tuple{2, 6u, 4u}, {3, 6u, 4u}, {4, 8u, 4u}, {5, 9u, 3u}, {12, 9u, 4u}, {3, 30u, 12u}}) {
    for (int i = 0; i < 150; ++i) {
      const TriangleMesh mesh = soup(random, side, vertices, count);
      const MeshFault slow = slow_self_intersections(mesh), fast = fast_self_intersections(mesh);
      ASSERT_EQ(fast.count, slow.count) << testing::PrintToString(mesh.triangles) << " side " << side << " soup " << i;
      ASSERT_EQ(fast.examples, slow.examples);
      ++soups;
      free_soups += slow.count == 0;
      triangles += count;
      intersecting += slow.count;
    }
  }
  EXPECT_EQ(soups, 900);
  EXPECT_GT(free_soups, 150);
  EXPECT_GT(intersecting, triangles / 4);
  EXPECT_LT(intersecting, triangles * 3 / 4);
}

/// Pairs of triangles that share nothing, a vertex, an edge: enough of each, both ways.
TEST(SelfIntersections, AgreeWithExactClippingOfPairs) {
  std::mt19937_64 random(6);
  int seen[4][2] = {};
  for (int i = 0; i < 30000; ++i) {
    const TriangleMesh mesh = soup(random, i % 2 == 0 ? 3 : 4, 5, 2);
    const MeshFault slow = slow_self_intersections(mesh);
    ASSERT_EQ(fast_self_intersections(mesh), slow)
        << testing::PrintToString(mesh.triangles) << " of pair " << std::to_string(i);
    const auto& p = mesh.positions;
    std::size_t shared = 0;
    for (const std::uint32_t vertex : mesh.triangles[0])
      shared += std::ranges::any_of(mesh.triangles[1], [&](std::uint32_t other) { return p[vertex] == p[other]; });
    ++seen[std::min<std::size_t>(shared, 3)][slow.count > 0];
  }
  // Two of five vertices are common to any two proper triangles here, but for coincidences.
  for (const auto& [row, met] : {std::pair{1, 0}, {1, 1}, {2, 0}, {2, 1}, {3, 1}}) EXPECT_GT(seen[row][met], 50);
}

TEST(SelfIntersections, HoldAtAnyScale) {
  std::mt19937_64 random(7);
  std::uint64_t intersecting = 0;
  for (int i = 0; i < 60; ++i) {
    const TriangleMesh mesh = soup(random, 4, 12, 8);
    const MeshFault fault = fast_self_intersections(mesh);
    intersecting += fault.count;
    // Powers of two, so that nothing is rounded.
    for (const Vec3& by : {Vec3{0x1p-1000, 0x1p-1000, 0x1p-1000},
                           {0x1p1000, 0x1p1000, 0x1p1000},
                           {0x1p1000, 1, 0x1p-1000},
                           {0x1p-1074, 0x1p660, 1},
                           {0x1p-1074, 0x1p-1074, 0x1p-1074},
                           {0x1p1021, 0x1p1021, 0x1p-1074}})
      ASSERT_EQ(fast_self_intersections(scaled(mesh, by)), fault);
  }
  EXPECT_GT(intersecting, 100u);
}

TEST(SelfIntersections, OfAThousandCopiesAreFound) {
  TriangleMesh mesh;
  for (int i = 0; i < 1000; ++i) mesh = joined(std::move(mesh), tetrahedron());
  EXPECT_EQ(fast_self_intersections(mesh), (MeshFault{4000, {0, 1, 2, 3, 4}}));
}

}  // namespace
}  // namespace plumb
