#include "conformance/growth/growth_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "conformance/growth/growth_mesh.h"
#include "meshes/editing/subdivide.h"
#include "meshes/validation/mesh_report.h"

namespace plumb {
namespace {

bool is_single(double value) { return static_cast<double>(static_cast<float>(value)) == value; }

TEST(GrowthMesh, IsSoundAndTheSameSurfaceInEverySize) {
  TriangleMesh mesh = growth_mesh(3);
  EXPECT_EQ(mesh.triangles.size(), 1200u);
  const MeshReport report = check_mesh(mesh);
  EXPECT_TRUE(report.closed && report.manifold && report.oriented);
  EXPECT_EQ(report.outward, true);
  EXPECT_EQ(report.euler_characteristic, 2);
  EXPECT_EQ(report.self_intersections->count, 0u);
  for (int times = 0; times < 3; ++times) mesh = subdivided(mesh);
  // All midpoints are exact, so every number still fits single precision.
  int numbers = 0;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    for (const double value : {mesh.positions[i].x, mesh.positions[i].y, mesh.positions[i].z, mesh.normals[i].x,
                               mesh.normals[i].y, mesh.normals[i].z}) {
      volatile double stored = value;
      ASSERT_TRUE(is_single(stored)) << std::hexfloat << value;
      ++numbers;
    }
  }
  EXPECT_EQ(numbers, 6 * 38402);
  EXPECT_NE(growth_mesh(4), growth_mesh(3));
}

TEST(GrowthBalls, DoNotTouch) {
  const std::vector<GrowthBall> balls = growth_balls(1000, 5);
  ASSERT_EQ(balls.size(), 1000u);
  for (std::size_t i = 0; i < balls.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      ASSERT_GT(length(balls[i].center - balls[j].center), balls[i].radius + balls[j].radius);
}

TEST(GrowthCamera, IsExactlyAlongAnAxisOrWellInBetween) {
  int axes[3] = {};
  for (int round = 0; round < 60; ++round) {
    const Vec3 d = growth_camera(GrowthView::axis_aligned, round, 9).direction;
    int zeros = 0;
    for (int axis = 0; axis < 3; ++axis) d[axis] == 0 ? ++zeros : ++axes[axis];
    EXPECT_EQ(zeros, 2);
    const Vec3 oblique = normalized(growth_camera(GrowthView::oblique, round, 9).direction);
    for (int axis = 0; axis < 3; ++axis) EXPECT_GT(std::abs(oblique[axis]), 0.15);
  }
  for (const int count : axes) EXPECT_GT(count, 5);
}

TEST(FilledTemplate, ReplacesWhatItKnowsAndLeavesTheRest) {
  EXPECT_EQ(filled_template("a {mesh} {b} {\"json\": {width}} {", {{"mesh", "m.obj"}, {"width", "12"}}),
            "a m.obj {b} {\"json\": 12} {");
  EXPECT_EQ(filled_template("", {}), "");
  GrowthNames names = camera_names({{1, 2.5, -3}, {0, 0, -1}, {0, 1, 0}, 0.5, 0.25}, 7, 9);
  EXPECT_EQ(filled_template("{eye}|{eye_y}|{direction_z}|{up}|{width}x{height}|{view_width}", names),
            "1 2.5 -3|2.5|-1|0 1 0|7x9|0.5");
  EXPECT_EQ(filled_template("{center} {x} {radius}", ball_names({{1, 2, 3}, 0.5})), "1 2 3 1 0.5");
}

}  // namespace
}  // namespace plumb
