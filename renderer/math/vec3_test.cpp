#include "renderer/math/vec3.h"

#include <gtest/gtest.h>

#include <type_traits>

namespace plumb {
namespace {

template <class A, class B>
concept Addable = requires(A a, B b) {
  a + b;
};

TEST(Vec3, WrongMixturesDoNotCompile) {
  static_assert(!Addable<Point3, Point3>);
  static_assert(!Addable<Point3, Normal3>);
  static_assert(!Addable<Vec3, Color>);
  static_assert(std::is_same_v<decltype(Point3{} - Point3{}), Vec3>);
  static_assert(std::is_same_v<decltype(Point3{} + Vec3{}), Point3>);
}

TEST(Vec3, CrossFollowsTheRightHand) {
  EXPECT_EQ(cross({1, 0, 0}, {0, 1, 0}), (Vec3{0, 0, 1}));
  EXPECT_EQ(cross({0, 1, 0}, {0, 0, 1}), (Vec3{1, 0, 0}));
}

TEST(Vec3, NormalizedZeroIsNotFinite) {
  EXPECT_FALSE(is_finite(normalized(Vec3{})));
  EXPECT_EQ(normalized(Vec3{0, 3, 4}), (Vec3{0, 0.6, 0.8}));
}

}  // namespace
}  // namespace plumb
