#include "renderer/math/bounds3.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumb {
namespace {

TEST(Bounds3, StartsEmptyAndTakesItsFirstPoint) {
  Bounds3 b;
  EXPECT_TRUE(b.empty());
  EXPECT_EQ(b.half_area(), 0);
  b.extend(Bounds3{});
  EXPECT_TRUE(b.empty());
  b.extend(Point3{-1, 2, -3});
  EXPECT_EQ(b.min, b.max);
  EXPECT_FALSE(b.empty());
}

TEST(Bounds3, IgnoresNaN) {
  Bounds3 b;
  b.extend(Point3{1, 1, 1});
  b.extend(Point3{NAN, 2, 2});
  EXPECT_EQ(b.max, (Point3{1, 2, 2}));
}

TEST(Bounds3, HasEightCorners) {
  const Bounds3 b{{0, 0, 0}, {1, 2, 3}};
  EXPECT_EQ(b.corner(0), (Point3{0, 0, 0}));
  EXPECT_EQ(b.corner(5), (Point3{1, 0, 3}));
  EXPECT_EQ(b.corner(7), (Point3{1, 2, 3}));
  EXPECT_EQ(b.half_area(), 11);
  EXPECT_EQ(b.center(), (Point3{0.5, 1, 1.5}));
}

}  // namespace
}  // namespace plumb
