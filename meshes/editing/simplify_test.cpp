#include "meshes/editing/simplify.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "meshes/editing/manifold.h"
#include "meshes/generators/icosphere.h"

namespace plumb {
namespace {

/// The square from 0 to 1 in the plane z = 0, in n by n squares of two triangles.
TriangleMesh flat_square(std::uint32_t n) {
  TriangleMesh mesh;
  for (std::uint32_t y = 0; y <= n; ++y) {
    for (std::uint32_t x = 0; x <= n; ++x) {
      mesh.positions.push_back({double(x) / n, double(y) / n, 0});
      mesh.texcoords.push_back({double(x), double(y)});
      if (x == n || y == n) continue;
      const std::uint32_t a = y * (n + 1) + x;
      mesh.triangles.push_back({a, a + 1, a + n + 2});
      mesh.triangles.push_back({a, a + n + 2, a + n + 1});
    }
  }
  return mesh;
}

double area(const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    sum += length(cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a])) / 2;
  return sum;
}

TEST(Simplify, KeepsAFlatSquareWithItsCorners) {
  const Simplified result = simplified(flat_square(8), {.triangles = 2, .progress = {}});
  EXPECT_EQ(result.mesh.triangles.size(), 2u);
  EXPECT_EQ(result.mesh.positions, (std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
  EXPECT_EQ(result.mesh.texcoords, (std::vector<TexCoord>{{0, 0}, {8, 0}, {0, 8}, {8, 8}}));
  EXPECT_NEAR(area(result.mesh), 1, 1e-12);
  EXPECT_LT(result.largest_error, 1e-7);  // the root of what rounding leaves of squares
}

TEST(Simplify, KeepsASphereASphere) {
  const TriangleMesh sphere = icosphere(4);
  const Simplified result = simplified(sphere, {.triangles = 500, .progress = {}});
  EXPECT_LE(result.mesh.triangles.size(), 500u);
  EXPECT_GE(result.mesh.triangles.size(), 499u);
  EXPECT_EQ(manifold_fault(result.mesh), std::nullopt);
  EXPECT_EQ(result.mesh.positions.size(), result.mesh.triangles.size() / 2 + 2);  // closed, of genus 0
  const double whole = area(sphere);
  EXPECT_GT(area(result.mesh), .97 * whole);
  EXPECT_LT(area(result.mesh), whole);
  EXPECT_GT(result.largest_error, 0);
  EXPECT_LT(result.largest_error, .1);
  // Vertices and their normals, which are equal on this sphere, come from the mesh.
  EXPECT_EQ(result.mesh.normals.size(), result.mesh.positions.size());
  for (std::size_t i = 0; i < result.mesh.positions.size(); ++i) {
    EXPECT_EQ(as_vector(result.mesh.normals[i]), result.mesh.positions[i] - Point3{});
    EXPECT_NE(std::ranges::find(sphere.positions, result.mesh.positions[i]), sphere.positions.end());
  }
}

TEST(Simplify, GivesTheSameMeshAgainAndAtAnyScale) {
  TriangleMesh sphere = icosphere(3);
  const Simplified first = simplified(sphere, {.triangles = 100, .progress = {}});
  EXPECT_EQ(simplified(sphere, {.triangles = 100, .progress = {}}).mesh, first.mesh);
  for (const double scale : {0x1p-300, 0x1p+300}) {
    TriangleMesh other = sphere;
    for (Point3& p : other.positions) p = Point3{} + scale * (p - Point3{});
    const Simplified result = simplified(other, {.triangles = 100, .progress = {}});
    EXPECT_EQ(result.mesh.triangles, first.mesh.triangles) << scale;
    EXPECT_EQ(result.largest_error, scale * first.largest_error) << scale;
  }
}

TEST(Simplify, StopsWhereNothingMayGo) {
  EXPECT_EQ(simplified(icosphere(1), {.triangles = 1, .progress = {}}).mesh.triangles.size(), 4u);
  const TriangleMesh sphere = icosphere(0);
  EXPECT_EQ(simplified(sphere, {.triangles = 20, .progress = {}}).mesh, sphere);
  EXPECT_EQ(simplified({}, {.triangles = 1, .progress = {}}).mesh, TriangleMesh());
}

TEST(Simplify, TellsItsProgressToTheEnd) {
  std::vector<double> told;
  simplified(icosphere(5), {.triangles = 100, .progress = [&](double share) { told.push_back(share); }});
  EXPECT_GE(told.size(), 5u);
  EXPECT_TRUE(std::ranges::is_sorted(told));
  EXPECT_EQ(told.back(), 1);
}

TEST(Simplify, RefusesWhatIsNotManifold) {
  TriangleMesh mesh = icosphere(0);
  mesh.triangles.push_back(mesh.triangles[0]);
  EXPECT_THROW(simplified(mesh, {.triangles = 10, .progress = {}}), std::invalid_argument);
}

}  // namespace
}  // namespace plumb
