#include "meshes/editing/subdivide.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "meshes/generators/icosphere.h"

namespace plumb {
namespace {

/// Coordinates with few bits, so that three subdivisions round nothing.
TriangleMesh dyadic_tetrahedron() {
  return {{{0, 0, 0}, {8, .5, 0}, {-1, 4, 2}, {3, -2, 16}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}, {}, {}};
}

/// The edges that have not one triangle on either side.
std::size_t open_edges(const TriangleMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
  for (const auto& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3];
      balance[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
  }
  return static_cast<std::size_t>(std::ranges::count_if(balance, [](const auto& edge) { return edge.second != 0; }));
}

Vec3 doubled_area(const TriangleMesh& mesh, std::size_t i) {
  const auto& [a, b, c] = mesh.triangles[i];
  return cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
}

TEST(Subdivide, PutsEachFourthExactlyIntoItsTriangle) {
  TriangleMesh coarse = dyadic_tetrahedron();
  std::size_t cases = 0;
  for (int times = 0; times < 3; ++times) {
    const TriangleMesh fine = subdivided(coarse);
    ASSERT_EQ(fine.triangles.size(), 4 * coarse.triangles.size());
    for (std::size_t i = 0; i < fine.triangles.size(); ++i, ++cases) {
      const auto& t = coarse.triangles[i / 4];
      const Vec3 whole = doubled_area(coarse, i / 4), quarter = doubled_area(fine, i);
      ASSERT_EQ(4.0 * quarter, whole);  // the same plane, side and a fourth of the area: no rounding with these numbers
      for (const std::uint32_t v : fine.triangles[i]) {
        ASSERT_EQ(dot(whole, fine.positions[v] - coarse.positions[t[0]]), 0);
      }
    }
    coarse = fine;
  }
  EXPECT_EQ(cases, 16u + 64 + 256);
}

TEST(Subdivide, KeepsVerticesInFrontAndSharesMidpoints) {
  const TriangleMesh coarse = dyadic_tetrahedron(), fine = subdivided(coarse);
  ASSERT_EQ(fine.positions.size(), 4u + 6);
  EXPECT_TRUE(std::equal(coarse.positions.begin(), coarse.positions.end(), fine.positions.begin()));
  for (std::size_t i = 0; i < fine.positions.size(); ++i)
    EXPECT_EQ(std::ranges::count(fine.positions, fine.positions[i]), 1) << i;
}

TEST(Subdivide, KeepsAClosedMeshClosedAndAnOpenOneOpen) {
  TriangleMesh mesh = icosphere(1);
  EXPECT_EQ(open_edges(subdivided(subdivided(mesh))), 0u);
  mesh.triangles.pop_back();
  EXPECT_EQ(open_edges(mesh), 3u);
  EXPECT_EQ(open_edges(subdivided(mesh)), 6u);
}

TEST(Subdivide, InterpolatesNormalsAndTexcoordsWithoutMakingThemUnit) {
  const TriangleMesh mesh = {
      {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}, {{0, 1, 2}}, {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}}, {{0, 0}, {1, 0}, {0, 3}}};
  const TriangleMesh fine = subdivided(mesh);
  EXPECT_EQ(fine.normals,
            (std::vector<Normal3>{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {0, .5, .5}, {.5, .5, 0}, {.5, 0, .5}}));
  EXPECT_EQ(fine.texcoords, (std::vector<TexCoord>{{0, 0}, {1, 0}, {0, 3}, {.5, 0}, {.5, 1.5}, {0, 1.5}}));
}

TEST(Subdivide, TakesAnyMesh) {
  EXPECT_EQ(subdivided({}), TriangleMesh());
  // Three triangles at one edge, one of them turned, one triangle with a vertex twice, and a vertex of none.
  const TriangleMesh mesh = {
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {5, 5, 5}}, {{0, 1, 2}, {0, 1, 3}, {1, 0, 3}, {2, 2, 0}}, {}, {}};
  const TriangleMesh fine = subdivided(mesh);
  EXPECT_EQ(fine.triangles.size(), 16u);
  EXPECT_EQ(fine.positions.size(), 5u + 6);  // 01 12 20 13 30 and the edge from 2 to itself
  EXPECT_EQ(fine.positions[4], (Point3{5, 5, 5}));
}

TEST(Subdivide, ReachesTheMiddleOfTheLargestNumbers) {
  const double huge = 1.5e308;
  const TriangleMesh mesh = {{{huge, 0, 0}, {huge, 1, 0}, {huge, 0, 1}}, {{0, 1, 2}}, {}, {}};
  const TriangleMesh fine = subdivided(mesh);
  for (const Point3& p : fine.positions) EXPECT_EQ(p.x, huge);
}

}  // namespace
}  // namespace plumb
