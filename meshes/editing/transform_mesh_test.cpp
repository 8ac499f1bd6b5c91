#include "meshes/editing/transform_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "meshes/generators/icosphere.h"

namespace plumb {
namespace {

TEST(TransformMesh, CarriesNormalsByTheInverseTransposeAndMakesThemUnit) {
  const TriangleMesh mesh = {{{1, 2, 3}},
                             {},
                             {
                                 {0, 3, 3},
                             },
                             {{.5, .25}}};
  const TriangleMesh moved = transformed(mesh, Transform(translation({1, 0, 0}) * scaling({1, 1, 2})));
  EXPECT_EQ(moved.positions, (std::vector<Point3>{{2, 2, 6}}));
  EXPECT_EQ(moved.texcoords, mesh.texcoords);
  const double root = std::sqrt(5);  // (0, 1, 1/2), made unit
  EXPECT_NEAR(moved.normals[0].y, 2 / root, 1e-15);
  EXPECT_NEAR(moved.normals[0].z, 1 / root, 1e-15);
}

TEST(TransformMesh, KeepsNormalsUnitAtTheEndsOfTheRangeAndZeroOnesZero) {
  const TriangleMesh mesh = {{{0, 0, 0}, {0, 0, 0}}, {}, {{0, 1e300, 1e300}, {0, 0, 0}}, {}};
  for (const double factor : {1e-300, 1e300}) {
    const TriangleMesh moved = transformed(mesh, Transform(scaling({factor, factor, factor})));
    EXPECT_NEAR(moved.normals[0].y, std::sqrt(.5), 1e-15) << factor;
    EXPECT_EQ(moved.normals[1], Normal3()) << factor;
  }
}

/// Whether every triangle of an ellipsoid around `middle`, and the normals of its corners, face away from it.
bool faces_outward(const TriangleMesh& mesh, const Point3& middle) {
  for (const auto& t : mesh.triangles) {
    const Point3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    const Vec3 front = cross(b - a, c - a);
    if (!(dot(front, a - middle) > 0)) return false;
    for (const std::uint32_t v : t) {
      if (!(dot(mesh.normals[v], mesh.positions[v] - middle) > 0) ||
          std::fabs(length(as_vector(mesh.normals[v])) - 1) > 1e-15)
        return false;
    }
  }
  return true;
}

TEST(TransformMesh, KeepsTheFrontOutsideWhateverTheMap) {
  const TriangleMesh sphere = icosphere(2);
  ASSERT_TRUE(faces_outward(sphere, {}));
  std::mt19937 random(2011);
  std::uniform_real_distribution<double> entry(-2, 2);
  int mirrored = 0, cases = 0;
  for (int i = 0; i < 200; ++i) {
    AffineMatrix matrix;
    for (auto& row : matrix)
      for (double& e : row) e = entry(random);
    const AffineMatrix& m = matrix;
    const double determinant = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                               m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                               m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    if (std::fabs(determinant) < .1) continue;  // so flat that a face may be seen from its edge
    const TriangleMesh moved = transformed(sphere, Transform(matrix));
    EXPECT_TRUE(faces_outward(moved, {m[0][3], m[1][3], m[2][3]})) << "case " << i;
    EXPECT_EQ(is_mirroring(matrix), determinant < 0);
    mirrored += is_mirroring(matrix);
    ++cases;
  }
  EXPECT_GT(cases, 150);
  EXPECT_GT(mirrored, 60);
  EXPECT_GT(cases - mirrored, 60);
}

TEST(TransformMesh, KnowsAMirrorWhoseDeterminantRoundsToZero) {
  // The determinant is (1 + 2^-52)(1 - 2^-52) - 1 = -2^-104, and in another order the opposite.
  const double up = 1 + 0x1p-52, down = 1 - 0x1p-52;
  EXPECT_TRUE(is_mirroring({{{up, 1, 0, 0}, {1, down, 0, 0}, {0, 0, 1, 0}}}));
  EXPECT_FALSE(is_mirroring({{{1, down, 0, 0}, {up, 1, 0, 0}, {0, 0, 1, 0}}}));
  EXPECT_FALSE(is_mirroring(scaling({-1e-200, -1e200, 1})));
  EXPECT_TRUE(is_mirroring(scaling({-1e-300, 1e-300, 1e-300})));
  EXPECT_FALSE(is_mirroring(scaling({0, 1, 1})));
}

TEST(TransformMesh, RefusesToLeaveTheRange) {
  const TriangleMesh mesh = {{{1e200, 0, 0}}, {}, {}, {}};
  EXPECT_THROW(transformed(mesh, Transform(scaling({1e200, 1, 1}))), std::range_error);
}

TEST(TransformMesh, FitsABoxIntoTheUnitCube) {
  const TriangleMesh mesh = {{{1, 2, 3}, {5, 4, 4}}, {}, {}, {}};
  const Bounds3 box = bounds_of(mesh, scaling({1, 2, 1}));
  EXPECT_EQ(box, (Bounds3{{1, 4, 3}, {5, 8, 4}}));
  const Bounds3 fitted = bounds_of(mesh, unit_cube_from(box) * scaling({1, 2, 1}));
  EXPECT_EQ(fitted, (Bounds3{{-.5, -.5, -.125}, {.5, .5, .125}}));
  EXPECT_TRUE(bounds_of({}, identity_matrix()).empty());
}

}  // namespace
}  // namespace plumb
