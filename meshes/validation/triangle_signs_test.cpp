#include "meshes/validation/triangle_signs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace plumb {
namespace {

constexpr double kTiny = std::numeric_limits<double>::denorm_min();

/// Points p + k u with whole numbers: on a line, unless one coordinate is moved to its neighbour.
TEST(OnALine, IsExact) {
  std::mt19937_64 random(3);
  std::uniform_int_distribution<int> whole(-(1 << 20), 1 << 20);
  std::uniform_int_distribution<int> exponent(-1060, 990);
  int lines = 0, moved = 0;
  for (int i = 0; i < 5000; ++i) {
    double p[3], u[3];
    for (int axis = 0; axis < 3; ++axis) p[axis] = whole(random), u[axis] = whole(random);
    const double size = std::ldexp(1, exponent(random)), k = whole(random) % 1000 + 1001.0;
    const auto at = [&](double s) {
      return Point3{(p[0] + s * u[0]) * size, (p[1] + s * u[1]) * size, (p[2] + s * u[2]) * size};
    };
    Point3 a = at(0), b = at(1), c = at(k);
    EXPECT_TRUE(on_a_line(a, b, c)) << std::hexfloat << size;
    EXPECT_TRUE(on_a_line(c, a, b));
    ++lines;
    if (u[0] == 0 && u[1] == 0 && u[2] == 0) continue;
    const int axis = static_cast<int>(random() % 3);
    // Moved along itself, a line stays one.
    if (u[(axis + 1) % 3] == 0 && u[(axis + 2) % 3] == 0) continue;
    c[axis] = std::nextafter(c[axis], 1e308);
    EXPECT_FALSE(on_a_line(a, b, c)) << std::hexfloat << size;
    ++moved;
  }
  EXPECT_EQ(lines, 5000);
  EXPECT_GT(moved, 4900);
}

TEST(OnALine, OfPointsThatCoincide) {
  const Point3 p{1e300, -1e-300, 3}, q{-1e300, 5, kTiny};
  EXPECT_TRUE(on_a_line(p, p, q));
  EXPECT_TRUE(on_a_line(p, q, p));
  EXPECT_TRUE(on_a_line(p, p, p));
  EXPECT_FALSE(on_a_line(p, q, {0, 0, 0}));
}

/// Normals n = u + s (b - a) + r (c - a) with whole numbers: the sign is that of the part across.
TEST(SideOfNormal, IsExact) {
  std::mt19937_64 random(4);
  std::uniform_int_distribution<int> whole(-1000, 1000);
  int along = 0, across = 0;
  for (int i = 0; i < 5000; ++i) {
    const auto vector = [&] { return Vec3{double(whole(random)), double(whole(random)), double(whole(random))}; };
    const Point3 a = Point3{} + vector();
    const Vec3 u = vector(), v = vector(), n = cross(u, v);
    const Vec3 tangent = whole(random) * 0x1p20 * u + whole(random) * 0x1p20 * v;
    if (length(n) == 0) continue;
    // The scales keep everything a double.
    for (const double scale : {0x1p-1070, 0x1p-500, 1.0, 0x1p900}) {
      const auto at = [&](const Vec3& by) {
        return Point3{scale * (a.x + by.x), scale * (a.y + by.y), scale * (a.z + by.z)};
      };
      const auto side = [&](const Vec3& normal) { return side_of_normal(as_normal(normal), at({}), at(u), at(v)); };
      EXPECT_EQ(side(tangent), 0);
      EXPECT_EQ(side(tangent + n), 1);
      EXPECT_EQ(side(tangent - n), -1);
      EXPECT_EQ(side({}), 0);
      along += 2, across += 2;
    }
  }
  EXPECT_GT(along, 30000);
  EXPECT_GT(across, 30000);
}

TEST(SideOfNormal, AtTheEndsOfTheRange) {
  const Point3 a{0, 0, 0}, b{1e300, 0, 0}, c{0, kTiny, 0};
  EXPECT_EQ(side_of_normal({1e308, 1e308, kTiny}, a, b, c), 1);
  EXPECT_EQ(side_of_normal({1e308, 1e308, -kTiny}, a, b, c), -1);
  EXPECT_EQ(side_of_normal({1e308, 1e308, 0}, a, b, c), 0);
}

}  // namespace
}  // namespace plumb
