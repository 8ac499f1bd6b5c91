#include "renderer/surfaces/closest_triangle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <numeric>
#include <random>

#include "meshes/generators/icosphere.h"

namespace plumb {
namespace {

TriangleMesh mesh_of(const std::vector<TriangleVertices>& triangles) {
  TriangleMesh mesh;
  for (const auto& triangle : triangles) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), triangle.begin(), triangle.end());
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

/// Parallel to the xy plane, its corners 1 apart.
TriangleVertices at_height(double z) { return {Point3{0, 0, z}, Point3{1, 0, z}, Point3{0, 1, z}}; }

std::optional<SurfaceHit> closest(const PlacedRay& ray, const TriangleMesh& mesh,
                                  const std::vector<std::uint32_t>& order) {
  ClosestTriangle closest(ray, mesh, 100);
  for (const std::uint32_t triangle : order) closest.offer(triangle);
  return closest.result();
}

TEST(ClosestTriangle, HitsThatRoundToTheSameTAreOrderedExactly) {
  // The ray's t at height z is (z + 3) / 3: neighbouring z share a rounded t, or even swap.
  std::vector<TriangleVertices> triangles;
  double z = 1;
  for (int i = 0; i < 8; ++i, z = std::nextafter(z, 2)) triangles.insert(triangles.begin(), at_height(z));
  const TriangleMesh mesh = mesh_of(triangles);
  const Ray ray{{0.25, 0.25, -3}, {0, 0, 3}};
  const PlacedRay placed(ray);
  std::vector<std::uint32_t> order(8);
  std::iota(order.begin(), order.end(), 0U);
  int orders = 0;
  do {
    const auto hit = closest(placed, mesh, order);
    ASSERT_TRUE(hit);
    ASSERT_EQ(hit->part, 7u) << "the last of them is the lowest";
  } while (std::next_permutation(order.begin(), order.end()) && ++orders < 5000);
  EXPECT_EQ(orders, 5000);
}

TEST(ClosestTriangle, OfEqualOnesTheLowestIndexWinsWhateverTheOrder) {
  const TriangleMesh mesh = mesh_of({at_height(2), at_height(1), at_height(1), at_height(1)});
  const Ray ray{{0.25, 0.25, -1}, {0, 0, 0.7}};
  const PlacedRay placed(ray);
  EXPECT_EQ(closest(placed, mesh, {3, 2, 1, 0})->part, 1u);
  EXPECT_EQ(closest(placed, mesh, {0, 1, 2, 3})->part, 1u);
  EXPECT_EQ(closest(placed, mesh, {1, 3, 1, 2, 1})->part, 1u) << "offered again";
}

TEST(ClosestTriangle, RangeEndsAtTheExactT) {
  const TriangleMesh mesh = mesh_of({at_height(1)});
  // t is 1 / 3, which lies above the nearest double.
  const double below = 1.0 / 3, above = std::nextafter(below, 1);
  const auto hit = [&](double from, double to) {
    const Ray ray{{0.25, 0.25, 0}, {0, 0, 3}, from, to};
    const PlacedRay placed(ray);
    const auto found = closest(placed, mesh, {0});
    ClosestTriangle any(placed, mesh, 1);
    EXPECT_EQ(any.meets(0), found.has_value());
    EXPECT_TRUE(!found || ray.contains(found->t));
    return found.has_value();
  };
  EXPECT_TRUE(hit(0, above));
  EXPECT_FALSE(hit(0, below));
  EXPECT_TRUE(hit(below, 1));
  EXPECT_FALSE(hit(above, 1));
  EXPECT_FALSE(hit(1, 0));
}

TEST(ClosestTriangle, PruningDistanceNeverLosesWhatIsNearer) {
  const TriangleMesh mesh = mesh_of({at_height(2), at_height(1)});
  const Ray ray{{0.25, 0.25, 0}, {0, 0, 3}, 0, 10};
  PlacedRay placed(ray);
  ClosestTriangle closest(placed, mesh, 2);
  EXPECT_EQ(closest.t_max(), 10);
  closest.offer(0);
  EXPECT_GE(closest.t_max(), 2.0 / 3);
  EXPECT_LE(closest.t_max(), 2.0 / 3 + 1e-10);
  closest.offer(1);
  EXPECT_LE(closest.t_max(), 1.0 / 3 + 1e-10);
  placed.nearest = 0.25;
  EXPECT_EQ(ClosestTriangle(placed, mesh, 2).t_max(), 0.25);
}

TEST(ClosestTriangle, RayWithNanMeetsNothing) {
  const TriangleMesh mesh = mesh_of({at_height(1)});
  int rays = 0;
  const Transform twice(scaling({2, 2, 2}));
  for (int i = -1; i < 8; ++i) {
    Ray ray{{0.25, 0.25, 0}, {0, 0, 3}};
    if (i >= 0) (i < 3 ? ray.origin[i] : i < 6 ? ray.direction[i - 3] : i == 6 ? ray.t_min : ray.t_max) = std::nan("");
    EXPECT_EQ(closest(PlacedRay(ray), mesh, {0}).has_value(), i < 0) << i;
    EXPECT_EQ(closest(PlacedRay(ray, twice), mesh, {0}).has_value(), i < 0) << i;
    ++rays;
  }
  EXPECT_EQ(rays, 9);
}

/// The numbers to the bit, without the padding between them.
std::array<std::uint64_t, 4> bits(const SurfaceHit& hit) {
  return {std::bit_cast<std::uint64_t>(hit.t), std::bit_cast<std::uint64_t>(hit.u), std::bit_cast<std::uint64_t>(hit.v),
          std::bit_cast<std::uint64_t>(hit.t_error)};
}

TEST(ClosestTriangle, IsTheSameFromAnyOrderOnASphere) {
  // Rays at its vertices, where five or six triangles have one t.
  const TriangleMesh mesh = icosphere(1);
  std::vector<std::uint32_t> order(mesh.triangles.size());
  std::iota(order.begin(), order.end(), 0U);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> u(-1, 1);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const Point3 origin{3 * u(random), 3 * u(random), 3 * u(random)};
    const Ray ray{origin, mesh.positions[static_cast<std::size_t>(i) % mesh.positions.size()] - origin};
    const PlacedRay placed(ray);
    const auto first = closest(placed, mesh, order);
    std::shuffle(order.begin(), order.end(), random);
    const auto second = closest(placed, mesh, order);
    ASSERT_EQ(first.has_value(), second.has_value());
    if (!first) continue;
    ASSERT_EQ(first->part, second->part);
    ASSERT_EQ(bits(*first), bits(*second));
    ++hits;
  }
  EXPECT_GT(hits, 1500);
}

}  // namespace
}  // namespace plumb
