#include "meshes/editing/vertex_normals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "meshes/generators/icosphere.h"

namespace plumb {
namespace {

/// The unit cube, each side of two triangles, so that a corner has one or two triangles of a side.
TriangleMesh cube() {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) mesh.positions.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2)});
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

void expect_near(const Normal3& a, const Normal3& b, double tolerance) {
  EXPECT_LE(length(as_vector(a) - as_vector(b)), tolerance)
      << a.x << " " << a.y << " " << a.z << " instead of " << b.x << " " << b.y << " " << b.z;
}

TEST(VertexNormals, WeightTrianglesByAngleOrArea) {
  TriangleMesh mesh = cube();
  EXPECT_EQ(compute_normals(mesh, NormalWeight::kAngle), 0u);
  const double third = std::sqrt(1. / 3);
  // Every side has a right angle at a corner, however it is cut. Five roundings of numbers near 1.
  for (int i = 0; i < 8; ++i)
    expect_near(mesh.normals[static_cast<std::size_t>(i)],
                {i & 1 ? third : -third, i >> 1 & 1 ? third : -third, i >> 2 ? third : -third}, 1e-15);
  EXPECT_EQ(compute_normals(mesh, NormalWeight::kArea), 0u);
  // Vertex 1 has one triangle of the sides z = 0 and y = 0 each, and two of x = 1.
  expect_near(mesh.normals[1], {2 / std::sqrt(6), -1 / std::sqrt(6), -1 / std::sqrt(6)}, 1e-15);
}

TEST(VertexNormals, AreCloseToThoseOfASphereAtAnyScale) {
  for (const double scale : {1.0, 1e-200, 1e200}) {
    TriangleMesh mesh = icosphere(4);
    const std::vector<Normal3> exact = mesh.normals;
    for (Point3& p : mesh.positions) p = Point3{} + scale * (p - Point3{});
    for (const NormalWeight weight : {NormalWeight::kArea, NormalWeight::kAngle}) {
      EXPECT_EQ(compute_normals(mesh, weight), 0u);
      double worst = 0;
      for (std::size_t i = 0; i < exact.size(); ++i)
        worst = std::max(worst, length(as_vector(mesh.normals[i]) - as_vector(exact[i])));
      EXPECT_LT(worst, .01)
          << scale;  // edges of 0.07: a face leans 0.035 away, and the leanings cancel but for a few percent
    }
  }
}

TEST(VertexNormals, GiveWhatHasNoneTheZAxis) {
  TriangleMesh mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {2, 0, 0}, {9, 9, 9}},
                       {{0, 2, 1}, {1, 3, 0}, {0, 0, 1}},  // the second has no area
                       {},
                       {}};
  EXPECT_EQ(compute_normals(mesh, NormalWeight::kArea), 2u);
  EXPECT_EQ(mesh.normals, (std::vector<Normal3>{{0, 1, 0}, {0, 1, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 1}}));
  mesh.triangles.push_back({0, 1, 2});  // the other side of the first: both cancel
  EXPECT_EQ(compute_normals(mesh, NormalWeight::kArea), 5u);
  TriangleMesh empty;
  EXPECT_EQ(compute_normals(empty, NormalWeight::kAngle), 0u);
}

TEST(VertexNormals, FlipTurnsTheMeshInsideOut) {
  TriangleMesh mesh = icosphere(1);
  const TriangleMesh before = mesh;
  flip(mesh);
  EXPECT_EQ(mesh.normals[3], -before.normals[3]);
  EXPECT_EQ(mesh.triangles[0],
            (std::array<std::uint32_t, 3>{before.triangles[0][0], before.triangles[0][2], before.triangles[0][1]}));
  flip(mesh);
  EXPECT_EQ(mesh, before);
}

TEST(Creases, GiveEachSideOfACubeItsOwnCorners) {
  TriangleMesh mesh = cube();
  EXPECT_EQ(split_at_creases(mesh, 89), 16u);
  EXPECT_EQ(mesh.positions.size(), 24u);
  compute_normals(mesh, NormalWeight::kArea);
  for (const Normal3& n : mesh.normals) EXPECT_EQ(std::fabs(n.x) + std::fabs(n.y) + std::fabs(n.z), 1);
  for (std::size_t i = 8; i < 24; ++i) EXPECT_LE(std::ranges::count(mesh.positions, mesh.positions[i]), 3);
}

TEST(Creases, LeaveWhatIsSmooth) {
  TriangleMesh mesh = cube();
  EXPECT_EQ(split_at_creases(mesh, 91), 0u);
  EXPECT_EQ(mesh, cube());
  mesh = icosphere(3);
  const TriangleMesh sphere = mesh;
  EXPECT_EQ(split_at_creases(mesh, 30), 0u);
  EXPECT_EQ(mesh, sphere);
}

TEST(Creases, SeparateTrianglesThatMeetInAVertexAlone) {
  TriangleMesh mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {7, 7, 7}},
                       {{0, 1, 2}, {0, 3, 4}},
                       {},
                       {{0, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 5}, {0, 6}}};
  EXPECT_EQ(split_at_creases(mesh, 30), 1u);
  EXPECT_EQ(mesh.triangles[1], (std::array<std::uint32_t, 3>{6, 3, 4}));
  EXPECT_EQ(mesh.texcoords[6], (TexCoord{0, 1}));
}

TEST(Creases, CountATriangleWithoutAreaAsSmooth) {
  TriangleMesh mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}}, {{0, 1, 2}, {1, 0, 3}}, {}, {}};
  EXPECT_EQ(split_at_creases(mesh, 1), 0u);
}

}  // namespace
}  // namespace plumb
