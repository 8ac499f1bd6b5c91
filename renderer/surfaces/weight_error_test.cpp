#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "renderer/math/dyadic.h"
#include "renderer/surfaces/triangle.h"

namespace plumb {
namespace {

using Exact = std::array<Dyadic, 3>;

Exact cross(const Exact& p, const Exact& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}
Dyadic dot(const Exact& p, const Exact& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }

Exact column(const AffineMatrix& m, std::size_t j) { return {m[0][j], m[1][j], m[2][j]}; }

Exact seen(const AffineMatrix& m, const Point3& p, const Point3& origin) {
  Exact result;
  for (std::size_t i = 0; i < 3; ++i)
    result[i] =
        Dyadic(m[i][0]) * p.x + Dyadic(m[i][1]) * p.y + Dyadic(m[i][2]) * p.z + m[i][3] - origin[static_cast<int>(i)];
  return result;
}

/// The weights as the sheared points would have them for the exact ray of the object's frame: those of world space over
/// the determinant of the matrix and the exact direction's coordinate along kz (by Cramer's rule).
std::array<long double, 3> exact_weights(const AffineMatrix& m, const Ray& world, int kz,
                                         const std::array<Point3, 3>& corners) {
  const Exact a = seen(m, corners[0], world.origin), b = seen(m, corners[1], world.origin),
              c = seen(m, corners[2], world.origin);
  const Exact d{world.direction.x, world.direction.y, world.direction.z};
  std::array<Exact, 3> columns{column(m, 0), column(m, 1), column(m, 2)};
  // det(M) times the coordinate is the determinant with that column replaced.
  columns[static_cast<std::size_t>(kz)] = d;
  const long double scale = dot(columns[0], cross(columns[1], columns[2])).rounded();
  return {dot(d, cross(c, b)).rounded() / scale, dot(d, cross(a, c)).rounded() / scale,
          dot(d, cross(b, a)).rounded() / scale};
}

struct Worst {
  double ratio = 0;
  int weights = 0;

  void measure(const AffineMatrix& m, const Ray& world, const std::array<Point3, 3>& corners) {
    const Transform transform(m);
    const PlacedRay placed(world, transform);
    const ShearedRay ray(placed);
    const ShearedTriangle triangle(ray, corners[0], corners[1], corners[2]);
    double reach = 0;
    for (const auto& p : triangle.plane) reach += std::fabs(p.x) + std::fabs(p.y);
    const double bound = weight_error(triangle.largest(), reach, ray.drift, ray.drift_growth);
    const auto exact = exact_weights(m, world, ray.kz, corners);
    for (std::size_t i = 0; i < 3; ++i) {
      ratio = std::max(ratio, static_cast<double>(std::fabs(triangle.weights[i] - exact[i]) / bound));
      ++weights;
    }
  }
};

class WeightError : public ::testing::Test {
 protected:
  double number() { return u_(random_); }
  double magnitude(double low, double high) { return low * std::pow(high / low, (1 + number()) / 2); }
  Point3 point(double size, const Point3& around = {}) {
    const double x = size * number(), y = size * number(), z = size * number();
    return {around.x + x, around.y + y, around.z + z};
  }
  std::array<Point3, 3> triangle(const Point3& around, double size) {
    const Point3 a = point(size, around), b = point(size, around), c = point(size, around);
    return {a, b, c};
  }

  std::mt19937_64 random_{41};
  std::uniform_real_distribution<double> u_{-1, 1};
};

TEST_F(WeightError, HoldsForRaysAsGiven) {
  Worst worst;
  for (int i = 0; i < 20000; ++i) {
    const auto corners = triangle(point(magnitude(1e-3, 1e3)), magnitude(1e-6, 1e3));
    Ray ray{point(magnitude(1e-3, 1e3)), {}};
    ray.direction = corners[0] + 0.5 * (1 + number()) * (corners[1] - corners[0]) - ray.origin;
    worst.measure(identity_matrix(), ray, corners);
  }
  EXPECT_EQ(worst.weights, 60000);
  EXPECT_LE(worst.ratio, 1);
  EXPECT_GT(worst.ratio, 0.02) << "the bound is not far off";
}

TEST_F(WeightError, HoldsForPlacedRays) {
  Worst worst;
  int measured = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 first{180 * number(), 180 * number(), 180 * number()};
    const Vec3 second{180 * number(), 180 * number(), 180 * number()};
    const Vec3 factors{magnitude(1e-3, 1e3), -magnitude(1e-3, 1e3), magnitude(1e-3, 1e3)};
    AffineMatrix m = rotation_degrees(first) * scaling(factors) * rotation_degrees(second);
    for (auto& row : m) row[3] = magnitude(1e-3, 1e6) * number();
    const Transform transform(m);
    const auto corners = triangle(point(1), magnitude(1e-3, 1));
    Ray ray{transform(point(5)), {}};
    ray.direction = transform(corners[0] + 0.5 * (1 + number()) * (corners[1] - corners[0])) - ray.origin;
    const PlacedRay placed(ray, transform);
    if (!(ShearedRay(placed).drift_growth < 1)) continue;  // the filter decides nothing
    worst.measure(m, ray, corners);
    ++measured;
  }
  EXPECT_GE(measured, 15000);
  EXPECT_LE(worst.ratio, 1);
  EXPECT_GT(worst.ratio, 0.02);
}

}  // namespace
}  // namespace plumb
