#include "renderer/math/frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace plumb {
namespace {

constexpr double kUnit = 0x1p-53;

/// By how much the frame is off, in units of 2^-53: the largest of the products that should be 0 and the lengths that
/// should be 1, in exact enough arithmetic.
double fault(const std::array<Vec3, 3>& frame) {
  const auto product = [](const Vec3& a, const Vec3& b) {
    return static_cast<long double>(a.x) * b.x + static_cast<long double>(a.y) * b.y +
           static_cast<long double>(a.z) * b.z;
  };
  long double worst = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    worst = std::max(worst, std::fabs(std::sqrt(product(frame[i], frame[i])) - 1));
    worst = std::max(worst, std::fabs(product(frame[i], frame[(i + 1) % 3])));
  }
  return static_cast<double>(worst / kUnit);
}

/// The bound that the header promises, handedness, and w along the direction.
void expect_frame(const Vec3& direction) {
  const std::array<Vec3, 3> frame = frame_about(direction);
  EXPECT_LE(fault(frame), 4) << std::hexfloat << direction.x << ' ' << direction.y << ' ' << direction.z;
  EXPECT_GT(dot(cross(frame[0], frame[1]), frame[2]), 0.99);
  for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(std::signbit(frame[2][axis]), std::signbit(direction[axis]));
}

TEST(Frame, IsOrthonormalAlongAxesAndPlanes) {
  int count = 0;
  const double values[]{0.0, -0.0, 1, -1, 1e-9, -1e-9, 1e-300, 0.5};
  for (const double x : values)
    for (const double y : values)
      for (const double z : values) {
        if (x == 0 && y == 0 && z == 0) continue;
        expect_frame({x, y, z});
        ++count;
      }
  EXPECT_EQ(count, 512 - 8);
}

TEST(Frame, IsOrthonormalForAnyDirection) {
  std::mt19937_64 random(20240607);
  std::normal_distribution<double> normal;
  double worst = 0;
  for (int i = 0; i < 200'000; ++i) {
    Vec3 direction{normal(random), normal(random), normal(random)};
    // Every third close to an axis, where other constructions divide by little.
    if (i % 3 == 0) direction[i / 3 % 3] *= std::ldexp(1.0, i % 60);
    worst = std::max(worst, fault(frame_about(direction)));
  }
  EXPECT_LE(worst, 4);
  EXPECT_GT(worst, 0.5) << "nothing was tried";
}

TEST(Frame, TakesAnyLength) {
  for (const double length : {std::numeric_limits<double>::max(), std::numeric_limits<double>::min(), 1e200, 1e-200,
                              std::numeric_limits<double>::denorm_min() * 8})
    expect_frame({-length / 2, length / 4, length});
}

TEST(Frame, HasNoneForNoDirection) {
  for (const double x : {0.0, std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_TRUE(std::isnan(frame_about({x, 0, 0})[2].x));
}

}  // namespace
}  // namespace plumb
