#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "meshes/formats/write_msh.h"
#include "meshes/generators/icosphere.h"
#include "renderer/scene_for_tests.h"

namespace plumb {
namespace {

/// Translations, rotations and scales of either sign; the factors of scale are not below 0.2.
Transform random_transform(std::mt19937_64& random) {
  std::uniform_real_distribution<double> u(-1, 1);
  const auto factor = [&] { return std::copysign(0.2 + 2 * std::fabs(u(random)), u(random)); };
  return Transform(translation({9 * u(random), 9 * u(random), 9 * u(random)}) *
                   rotation_degrees({180 * u(random), 180 * u(random), 180 * u(random)}) *
                   scaling({factor(), factor(), factor()}));
}

using Extended = long double;

/// Coordinate `axis` of the mapped point in 64-bit significands.
Extended mapped(const Transform& t, const Extended (&p)[3], std::size_t axis) {
  const auto& row = t.matrix()[axis];
  return row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + static_cast<Extended>(row[3]);
}

/// Points of the unit sphere, cylinder (radius 1, |z| <= 1) or their like, in object space.
enum class Shape { sphere, cylinder, cone };

void sample(Shape shape, std::mt19937_64& random, Extended (&p)[3]) {
  std::uniform_real_distribution<double> u(-1, 1);
  const Extended angle = std::numbers::pi * u(random);
  const Extended z = u(random);
  Extended radius = 1;
  p[2] = z;
  if (shape == Shape::sphere) radius = std::sqrt(1 - z * z);
  if (shape == Shape::cone) radius = (3 - z) / 2;  // tip at z = 3, radius 1 at z = 1
  if (shape != Shape::sphere && u(random) > 0) {
    p[2] = z > 0 ? 1 : -1;
    radius = shape == Shape::cone ? (3 - p[2]) / 2 : 1;
  }
  p[0] = radius * std::cos(angle);
  p[1] = radius * std::sin(angle);
}

void expect_contained(const std::string& element, Shape shape) {
  const OneSurface surface(element);
  std::mt19937_64 random(31);
  int cases = 0, near_a_side = 0;
  for (int i = 0; i < 300; ++i) {
    const Transform transform = random_transform(random);
    const Bounds3 bounds = surface->world_bounds(transform);
    for (int k = 0; k < 100; ++k) {
      Extended p[3];
      sample(shape, random, p);
      for (int axis = 0; axis < 3; ++axis) {
        const Extended x = mapped(transform, p, static_cast<std::size_t>(axis));
        // The sample is off the surface by a few 2^-64 of at most 6; doubles near 30 lie 2^-48 apart.
        EXPECT_GE(x, bounds.min[axis] - 0x1p-58L) << element << " transform " << i;
        EXPECT_LE(x, bounds.max[axis] + 0x1p-58L) << element << " transform " << i;
        const Extended extent = bounds.max[axis] - static_cast<Extended>(bounds.min[axis]);
        near_a_side += x - bounds.min[axis] < 0.01L * extent || bounds.max[axis] - x < 0.01L * extent;
      }
      ++cases;
    }
  }
  EXPECT_EQ(cases, 30000);
  EXPECT_GT(near_a_side, 900) << "the samples come near the sides, so a box that is too small would show";
}

TEST(WorldBounds, HoldTheTransformedSphere) { expect_contained("<surface type='Sphere'/>", Shape::sphere); }
TEST(WorldBounds, HoldTheTransformedCylinder) {
  expect_contained("<surface type='Cylinder'><height>2</height></surface>", Shape::cylinder);
}
TEST(WorldBounds, HoldTheTransformedCone) {
  expect_contained("<surface type='Cone'><center>0 0 1</center><tipz>3</tipz><height>4</height></surface>",
                   Shape::cone);
}

TEST(WorldBounds, OfASphereAreTight) {
  // Along axis i it reaches r |row i|: the bounds may be wider by one rounding, and the referee here is off by some
  // 2^-63 of centre and extent.
  const OneSurface sphere("<surface type='Sphere'><center>1 2 3</center><radius>2</radius></surface>");
  std::mt19937_64 random(37);
  int cases = 0, smaller_than_box = 0;
  for (int i = 0; i < 1000; ++i, ++cases) {
    const Transform transform = random_transform(random);
    const Bounds3 bounds = sphere->world_bounds(transform);
    const Bounds3 box = transform(sphere->bounds());
    for (int axis = 0; axis < 3; ++axis) {
      const auto& row = transform.matrix()[static_cast<std::size_t>(axis)];
      const Extended extent =
          2 * std::sqrt(static_cast<Extended>(row[0]) * row[0] + static_cast<Extended>(row[1]) * row[1] +
                        static_cast<Extended>(row[2]) * row[2]);
      const Extended center = row[0] * 1.0L + row[1] * 2.0L + row[2] * 3.0L + row[3];
      const Extended slack = 0x1p-60L * (std::fabs(center) + extent + 30);
      EXPECT_LE(std::nextafter(bounds.max[axis], -INFINITY), center + extent + slack);
      EXPECT_GE(bounds.max[axis], center + extent - slack);
      EXPECT_GE(std::nextafter(bounds.min[axis], INFINITY), center - extent - slack);
      EXPECT_LE(bounds.min[axis], center - extent + slack);
      smaller_than_box += bounds.max[axis] < box.max[axis] - 1e-3;
    }
  }
  EXPECT_EQ(cases, 1000);
  EXPECT_GT(smaller_than_box, 2000) << "the box around the sphere's turned box is looser by up to sqrt 3";
}

TEST(WorldBounds, OfATurnedCylinderAreTight) {
  // A quarter turn about x lays the axis along -y: half extents (1, 2, 1) around (0, 0, 0), exactly.
  const OneSurface cylinder("<surface type='Cylinder'><height>4</height></surface>");
  const Bounds3 bounds = cylinder->world_bounds(Transform(rotation_degrees({90, 0, 0})));
  const double expected[] = {1, 2, 1};
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(bounds.max[axis], expected[axis]);
    EXPECT_EQ(bounds.min[axis], -expected[axis]);
  }
}

TEST(WorldBounds, OfABoxAreThoseOfItsCorners) {
  const OneSurface box("<surface type='Box'><minPt>-1 -2 -3</minPt><maxPt>1 2 3</maxPt></surface>");
  const auto expect = [&](const AffineMatrix& matrix, const Bounds3& exact) {
    EXPECT_EQ(box->world_bounds(Transform(matrix)), exact);
  };
  expect(rotation_degrees({0, 0, 90}), {{-2, -1, -3}, {2, 1, 3}});
  expect(translation({1, 1, 1}) * scaling({-1, 2, 1}), {{0, -3, -2}, {2, 5, 4}});
}

TEST(WorldBounds, OfAConeAreThoseOfItsEndDiscs) {
  // Tip at z = 3, radius 1 at z = 0, from -1 to 1: the discs have radius 4/3 and 2/3. A double cone, with its tip
  // within, has its larger disc at the far end.
  const OneSurface cone("<surface type='Cone'><tipz>3</tipz><height>2</height></surface>");
  const double up = std::nextafter(4.0 / 3, 2);  // 4/3 rounds down
  EXPECT_EQ(cone->bounds(), (Bounds3{{-up, -up, -1}, {up, up, 1}}));
  EXPECT_EQ(cone->world_bounds(Transform(rotation_degrees({90, 0, 0}))), (Bounds3{{-up, -1, -up}, {up, 1, up}}));
  const OneSurface both("<surface type='Cone'><tipz>1</tipz><height>6</height></surface>");
  EXPECT_EQ(both->bounds(), (Bounds3{{-4, -4, -3}, {4, 4, 3}}));
}

TEST(WorldBounds, OfAMeshAreThoseOfTheVerticesThatItUses) {
  // A square turned by 45 degrees within its plane: the corners of its box would reach sqrt 2 times as far. The last
  // vertex belongs to no triangle.
  TriangleMesh mesh;
  mesh.positions = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {9, 9, 9}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  write_msh(mesh, scene_test_file("turned.msh"));
  const OneSurface surface("<surface type='Mesh'><data>turned.msh</data></surface>");
  EXPECT_EQ(surface->bounds(), (Bounds3{{-1, -1, 0}, {1, 1, 0}}));
  const AffineMatrix turn = rotation_degrees({0, 0, 45});
  const double reach = turn[0][0];
  EXPECT_EQ(surface->world_bounds(Transform(turn)), (Bounds3{{-reach, -reach, 0}, {reach, reach, 0}}));
}

TEST(WorldBounds, OfALargeMeshAreThoseOfAllItsVertices) {
  const TriangleMesh sphere = in_single_precision(icosphere(4));
  write_msh(sphere, scene_test_file("large.msh"));
  const OneSurface surface("<surface type='Mesh'><data>large.msh</data></surface>");
  std::mt19937_64 random(5);
  int transforms = 0;
  for (; transforms < 50; ++transforms) {
    const Transform map = random_transform(random);
    Bounds3 exact;
    for (const Point3& p : sphere.positions) exact.extend(map(Bounds3{p, p}));
    EXPECT_EQ(surface->world_bounds(map), exact);
  }
  EXPECT_EQ(transforms, 50);
}

/// The exact largest coordinate of a mapped corner, in 113 bits: each product of two doubles is exact there, and the
/// sum of four is off by less than 2^-110 of its terms, far below the u = 2^-53 that matters here.
__extension__ using Quad = __float128;

TEST(WorldBounds, ABoxContainsItsMappedCornersWithoutRounding) {
  std::mt19937_64 random(31);
  std::uniform_real_distribution<double> u(-1, 1);
  int corners = 0, inside_by_rounding = 0;
  for (int i = 0; i < 1000; ++i) {
    const Bounds3 box{{u(random) - 2, u(random) - 2, u(random) - 2}, {u(random) + 2, u(random) + 2, u(random) + 2}};
    const Transform map(translation({1e3 * u(random), u(random), u(random)}) *
                        rotation_degrees({180 * u(random), 180 * u(random), 180 * u(random)}));
    const Bounds3 bounds = map(box);
    for (int c = 0; c < 8; ++c, ++corners) {
      const Point3 p = box.corner(c);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto& r = map.matrix()[axis];
        const Quad exact = Quad(r[0]) * p.x + Quad(r[1]) * p.y + Quad(r[2]) * p.z + r[3];
        const int a = static_cast<int>(axis);
        ASSERT_TRUE(exact >= bounds.min[a] && exact <= bounds.max[a]) << "case " << i;
        inside_by_rounding += exact != static_cast<Quad>(map(p)[a]);
      }
    }
  }
  EXPECT_EQ(corners, 8000);
  EXPECT_GT(inside_by_rounding, 10000) << "the margin was needed";
}

}  // namespace
}  // namespace plumb
