#include "renderer/math/transform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "renderer/math/rotation.h"

namespace plumb {
namespace {

TEST(Rotation, IsExactAtRightAngles) {
  EXPECT_EQ(cos_sin_degrees(90).cos, 0);
  EXPECT_EQ(cos_sin_degrees(90).sin, 1);
  EXPECT_EQ(cos_sin_degrees(180).sin, 0);
  EXPECT_EQ(cos_sin_degrees(-270).sin, 1);
  EXPECT_EQ(cos_sin_degrees(60).cos, 0.5);
  EXPECT_TRUE(std::isnan(cos_sin_degrees(INFINITY).cos));
}

TEST(Rotation, AppliesXFirstAndZLast) {
  // x: (0,1,0) -> (0,0,1); y: -> (1,0,0); z: -> (0,1,0).
  const Transform r(rotation_degrees({90, 90, 90}));
  EXPECT_EQ(r(Vec3{0, 1, 0}), (Vec3{0, 1, 0}));
  // x leaves (1,0,0); y: -> (0,0,-1); z leaves it. The reverse order would give (0,1,0)-like results.
  EXPECT_EQ(r(Vec3{1, 0, 0}), (Vec3{0, 0, -1}));
}

TEST(Transform, NormalsTakeTheInverseTranspose) {
  // M2 of the catalogue: diag(2,1,1) turns the plane x + y = 0 so that its normal is (1/2, 1, 0).
  const Transform t(scaling({2, 1, 1}));
  EXPECT_EQ(t(Normal3{1, 1, 0}), (Normal3{0.5, 1, 0}));
}

TEST(Transform, SingularOnesThrow) {
  EXPECT_THROW(Transform(scaling({1, 0, 1})), SingularTransform);
  EXPECT_THROW(Transform(rotation_degrees({10, 20, 30}) * scaling({1, 1, 0})), SingularTransform);
  EXPECT_THROW(Transform(scaling({NAN, 1, 1})), SingularTransform);
  EXPECT_THROW(Transform(scaling({1e-320, 1, 1})), SingularTransform);  // its inverse overflows
}

TEST(Transform, InverseUndoesRandomMaps) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> u(-1, 1);
  int cases = 0;
  for (int i = 0; i < 2000; ++i) {
    const AffineMatrix m = translation({u(random), u(random), u(random)}) *
                           rotation_degrees({180 * u(random), 180 * u(random), 180 * u(random)}) *
                           scaling({1.5 + u(random), 1.5 + u(random), 1.5 + u(random)});
    const Transform world_from_object(m);
    const Point3 p{u(random), u(random), u(random)};
    const Point3 back = world_from_object.inverse()(world_from_object(p));
    // Two matrix applications of three products each, on entries at most 2.5 / 0.5 in ratio: the error
    // stays below 2 * 8 u * |M^-1| |M| |p| with u = 2^-53, |M| |M^-1| <= 3.5 * 2 * 3.
    EXPECT_LE(length(back - p), 16 * 0x1p-53 * 21 * 4);
    ++cases;
  }
  EXPECT_EQ(cases, 2000);
}

TEST(Transform, RayKeepsItsParameter) {
  const Transform t(translation({1, 2, 3}) * scaling({2, 3, 4}));
  const Ray world = t(Ray{{0, 0, 0}, {1, 0, 0}, 1, 5});
  EXPECT_EQ(world.direction, (Vec3{2, 0, 0}));
  EXPECT_EQ(world.t_min, 1);
  EXPECT_EQ(world.t_max, 5);
  EXPECT_EQ(t.inverse_of(world).direction, (Vec3{1, 0, 0}));
}

TEST(Transform, KnowsTheIdentity) {
  EXPECT_TRUE(Transform().is_identity());
  EXPECT_TRUE(Transform(rotation_degrees({0, 0, 0})).is_identity());
  EXPECT_FALSE(Transform(translation({0, 0, 1e-300})).is_identity());
}

}  // namespace
}  // namespace plumb
