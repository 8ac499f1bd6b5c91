#include "bench/race/ray_sets.h"

#include <gtest/gtest.h>

#include <cmath>

#include "bench/race/float_numbers.h"
#include "meshes/generators/icosphere.h"

namespace plumb::bench {
namespace {

TriangleMesh ball() {
  TriangleMesh mesh = icosphere(3);
  for (Point3& p : mesh.positions) p = as_floats(p);
  return mesh;
}

/// The plainest search: every triangle, its plane and three sides.
Found closest(const TriangleMesh& mesh, const Ray& ray) {
  Found found;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto [ia, ib, ic] = mesh.triangles[i];
    const Vec3 a = mesh.positions[ia] - ray.origin, b = mesh.positions[ib] - ray.origin,
               c = mesh.positions[ic] - ray.origin;
    const double u = dot(ray.direction, cross(c, b)), v = dot(ray.direction, cross(a, c)),
                 w = dot(ray.direction, cross(b, a));
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) continue;
    const Vec3 normal = cross(b - a, c - a);
    const double t = dot(normal, a) / dot(normal, ray.direction);
    if (ray.contains(t) && (!found.hit() || t < found.t)) found = {t, i};
  }
  return found;
}

class RaySets : public testing::TestWithParam<std::string_view> {};

constexpr std::size_t kCount = 2000;

RaySet made(std::string_view name, const TriangleMesh& mesh) {
  return make_ray_set(name, mesh, kCount, [&](const Ray& ray) { return closest(mesh, ray); });
}

TEST_P(RaySets, BothFormsAreTheSameRays) {
  const RaySet set = made(GetParam(), ball());
  // 44 * 44 is the largest square below 2000.
  ASSERT_EQ(set.rays.size(), GetParam() == "primary" ? 1936u : kCount);
  ASSERT_EQ(set.floats.size(), set.rays.size());
  for (std::size_t i = 0; i < set.rays.size(); ++i) {
    const Ray& ray = set.rays[i];
    const FloatRay& same = set.floats[i];
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_EQ(ray.origin[axis], static_cast<double>(same.origin[axis])) << i;
      ASSERT_EQ(ray.direction[axis], static_cast<double>(same.direction[axis])) << i;
    }
    ASSERT_EQ(ray.t_min, static_cast<double>(same.t_min)) << i;
    ASSERT_EQ(ray.t_max, static_cast<double>(same.t_max)) << i;
  }
}

TEST_P(RaySets, TheSameArgumentsGiveTheSameRays) {
  const TriangleMesh mesh = ball();
  const RaySet one = made(GetParam(), mesh), two = made(GetParam(), mesh);
  ASSERT_EQ(one.rays.size(), two.rays.size());
  for (std::size_t i = 0; i < one.rays.size(); ++i) {
    ASSERT_EQ(one.rays[i].origin, two.rays[i].origin);
    ASSERT_EQ(one.rays[i].direction, two.rays[i].direction);
  }
}

INSTANTIATE_TEST_SUITE_P(All, RaySets, testing::ValuesIn(ray_set_names()),
                         [](const auto& name) { return std::string(name.param); });

std::size_t hits(const RaySet& set, const TriangleMesh& mesh) {
  std::size_t count = 0;
  for (const Ray& ray : set.rays) count += closest(mesh, ray).hit();
  return count;
}

// The box of a ball of radius 1 has d = 2 sqrt(3). The half width of the picture is tan(asin(.24)), the radius of the
// ball's disc tan(asin(1 / (1.25 d))) = tan(asin(.231)): a share of pi/4 (.2374 / .2472)^2 = .724.
TEST(RaySets, PrimaryRaysSeeTheWholeMesh) {
  const TriangleMesh mesh = ball();
  const RaySet set = made("primary", mesh);
  EXPECT_NEAR(static_cast<double>(hits(set, mesh)) / static_cast<double>(set.rays.size()), 0.724, 0.02);
}

// From outside every ray whose target lies within the ball hits it: at least pi / 6 of the box.
TEST(RaySets, IncoherentRaysComeFromOutside) {
  const TriangleMesh mesh = ball();
  const RaySet set = made("incoherent", mesh);
  EXPECT_GT(hits(set, mesh), kCount / 2);
  for (const Ray& ray : set.rays) EXPECT_GT(length(ray.origin - Point3{}), 3);
}

// A ball is convex: what leaves it does not come back, and what goes into it would hit.
TEST(RaySets, DiffuseRaysLeaveTheSurface) {
  const TriangleMesh mesh = ball();
  const RaySet set = made("diffuse", mesh);
  EXPECT_EQ(hits(set, mesh), 0u);
  double cosines = 0;
  for (const Ray& ray : set.rays) {
    EXPECT_NEAR(length(ray.origin - Point3{}), 1, 0.01);
    cosines += dot(ray.direction, ray.origin - Point3{});
  }
  // The cosine's mean under its own density is 2/3, its deviation sqrt(1/18) = .24, so .005 of the mean of 2000; facets
  // of this ball lean up to .08 from the radius.
  EXPECT_NEAR(cosines / kCount, 2.0 / 3, 0.03);
}

TEST(RaySets, ShadowRaysEndAtTheLight) {
  const TriangleMesh mesh = ball();
  const RaySet set = made("shadow", mesh);
  EXPECT_EQ(set.question, Question::any);
  const Point3 light = set.rays[0].at(1);
  for (const Ray& ray : set.rays) {
    EXPECT_EQ(ray.t_max, 1);
    EXPECT_LT(length(ray.at(1) - light), 1e-5);  // rounded to floats of about 5: 2^-22 each
  }
  const std::size_t blocked = hits(set, mesh);
  EXPECT_GT(blocked, kCount / 50);
  EXPECT_LT(blocked, kCount / 2);
}

/// How near the ray passes to the nearest of some points.
double nearest(const Ray& ray, const std::vector<Point3>& points) {
  double least = 1e9;
  for (const Point3& p : points)
    least = std::min(least, length(cross(p - ray.origin, ray.direction)) / length(ray.direction));
  return least;
}

// The directions have unit length and are rounded to 2^-25, over a way of 4.5: 1e-6 includes it with room.
TEST(RaySets, VertexRaysPassByVertices) {
  const TriangleMesh mesh = ball();
  for (const Ray& ray : made("vertex", mesh).rays) EXPECT_LT(nearest(ray, mesh.positions), 1e-6);
}

TEST(RaySets, EdgeRaysPassByEdges) {
  const TriangleMesh mesh = ball();
  std::size_t near_vertex = 0;
  const RaySet set = made("edge", mesh);
  for (const Ray& ray : set.rays) {
    double least = 1e9;
    for (const auto& triangle : mesh.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Point3& a = mesh.positions[triangle[k]];
        const Vec3 along = mesh.positions[triangle[(k + 1) % 3]] - a, across = cross(along, ray.direction);
        // Where the lines are closest, as a share of the edge.
        const double share = dot(cross(ray.origin - a, ray.direction), across) / dot(across, across);
        if (share < -1e-5 || share > 1 + 1e-5) continue;
        least = std::min(least, std::fabs(dot(ray.origin - a, across)) / length(across));
      }
    }
    EXPECT_LT(least, 1e-6);
    near_vertex += nearest(ray, mesh.positions) < 1e-4;
  }
  EXPECT_LT(near_vertex, kCount / 50);  // they are spread over the edges
}

TEST(RaySets, AnUnknownNameIsRefused) { EXPECT_THROW(made("sideways", ball()), std::invalid_argument); }

}  // namespace
}  // namespace plumb::bench
