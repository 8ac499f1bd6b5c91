#include "meshes/editing/loop_subdivide.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "meshes/editing/manifold.h"
#include "meshes/generators/icosphere.h"

namespace plumb {
namespace {

/// A vertex in the middle of `count` others on a circle.
TriangleMesh wheel(std::uint32_t count) {
  TriangleMesh mesh;
  mesh.positions.push_back({0, 0, 1});
  for (std::uint32_t i = 0; i < count; ++i) {
    const double angle = 6.283185307179586 * i / count;
    mesh.positions.push_back({std::cos(angle), std::sin(angle), 0});
    mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % count});
  }
  return mesh;
}

TEST(LoopSubdivide, MovesVerticesByLoopsWeights) {
  // A regular octahedron: each vertex has four neighbours, whose mean is the origin.
  TriangleMesh mesh = {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                       {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}},
                       {},
                       {}};
  mesh.normals.assign(6, {1, 0, 0});
  const TriangleMesh fine = loop_subdivided(mesh);
  ASSERT_EQ(fine.positions.size(), 6u + 12);
  ASSERT_EQ(fine.triangles.size(), 32u);
  EXPECT_TRUE(fine.normals.empty());
  EXPECT_EQ(manifold_fault(fine), std::nullopt);
  // alpha(4) = (40 - (3 + 2 cos 90)^2) / 64 = 31/64; libm's cosine of pi/2 is 6e-17 instead of 0.
  EXPECT_NEAR(fine.positions[0].x, 33.0 / 64, 1e-15);
  // 3/8 of each end; the opposite vertices, 1/8 each, cancel.
  for (std::size_t i = 6; i < 18; ++i) {
    const Point3& p = fine.positions[i];
    EXPECT_EQ(std::fabs(p.x) + std::fabs(p.y) + std::fabs(p.z), .75) << i;
  }
}

TEST(LoopSubdivide, KeepsABoundaryOnTheCurveOfItsVertices) {
  const TriangleMesh mesh = {{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}}, {{0, 1, 2}}, {}, {{0, 0}, {1, 0}, {0, 1}}};
  const TriangleMesh fine = loop_subdivided(mesh);
  ASSERT_EQ(fine.positions.size(), 6u);
  EXPECT_EQ(fine.positions[0], (Point3{1, 1, 0}));  // 6/8 of itself, 1/8 of each neighbour
  EXPECT_EQ(fine.positions[1], (Point3{6, 1, 0}));
  ASSERT_EQ(fine.texcoords.size(), 6u);
  for (std::size_t i = 3; i < 6; ++i) {
    // On the boundary new vertices are midpoints, and so are their texture coordinates.
    EXPECT_EQ(fine.positions[i].x, 8 * fine.texcoords[i].u) << i;
    EXPECT_EQ(fine.positions[i].y, 8 * fine.texcoords[i].v) << i;
  }
}

TEST(LoopSubdivide, TakesVerticesOfManyNeighboursAndOfNone) {
  TriangleMesh mesh = wheel(200);
  mesh.positions.push_back({7, 8, 9});
  const TriangleMesh fine = loop_subdivided(mesh);
  ASSERT_EQ(fine.triangles.size(), 800u);
  // alpha(200) = (40 - (3 + 2 cos(pi/100))^2) / 64, and the neighbours' mean is the origin.
  const double t = 3 + 2 * std::cos(3.141592653589793 / 100);
  EXPECT_NEAR(fine.positions[0].z, 1 - (40 - t * t) / 64, 1e-12);
  EXPECT_EQ(fine.positions[201], (Point3{7, 8, 9}));
  for (const Point3& p : fine.positions) EXPECT_TRUE(is_finite(p));
}

TEST(LoopSubdivide, RefusesWhatIsNotManifoldAndTakesAnEmptyMesh) {
  TriangleMesh bow = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}}, {}, {}};
  EXPECT_THROW(loop_subdivided(bow), std::invalid_argument);
  EXPECT_TRUE(loop_subdivided({}).triangles.empty());
}

}  // namespace
}  // namespace plumb
