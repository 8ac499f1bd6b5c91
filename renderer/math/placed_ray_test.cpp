#include "renderer/math/placed_ray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "renderer/math/dyadic.h"

namespace plumb {
namespace {

TEST(PlacedRay, HasNoErrorsWithoutATransform) {
  const Ray ray{{1, 2, 3}, {4, 5, 6}, 1, 2};
  const Transform identity;
  for (const PlacedRay& placed : {PlacedRay(ray), PlacedRay(ray, identity)}) {
    EXPECT_EQ(placed.object().origin, ray.origin);
    EXPECT_EQ(placed.object().direction, ray.direction);
    EXPECT_EQ(placed.object().t_max, 2);
    EXPECT_EQ(placed.origin_error, 0);
    EXPECT_EQ(placed.direction_error, 0);
    EXPECT_EQ(placed.drift(1e30), 0);
    EXPECT_EQ(placed.world_from_object, nullptr);
  }
}

/// M o' + T - o exactly, taken back by the inverse: o' less the exact origin. The residual is of the size of the
/// error, so that the inverse's own rounding is of the second order. `homogeneous` is 1 for points, 0 for directions.
template <class Triple>
double largest_error(const Transform& transform, const Triple& object, const Triple& world, double homogeneous) {
  long double residual[3];
  for (int i = 0; i < 3; ++i) {
    const auto& row = transform.matrix()[static_cast<std::size_t>(i)];
    residual[i] = (Dyadic(row[0]) * object.x + Dyadic(row[1]) * object.y + Dyadic(row[2]) * object.z +
                   Dyadic(row[3]) * homogeneous - world[i])
                      .rounded();
  }
  long double largest = 0;
  for (const auto& row : transform.inverse_matrix())
    largest = std::max(largest, std::fabs(row[0] * residual[0] + row[1] * residual[1] + row[2] * residual[2]));
  return static_cast<double>(largest);
}

struct RandomPlacing {
  std::mt19937_64 random{31};
  std::uniform_real_distribution<double> u{-1, 1};
  double magnitude(double low, double high) { return low * std::pow(high / low, (1 + u(random)) / 2); }
  Transform transform() {
    const Vec3 first{180 * u(random), 180 * u(random), 180 * u(random)};
    const Vec3 second{180 * u(random), 180 * u(random), 180 * u(random)};
    const Vec3 factors{magnitude(1e-3, 1e3), -magnitude(1e-3, 1e3), magnitude(1e-3, 1e3)};
    AffineMatrix matrix = rotation_degrees(first) * scaling(factors) * rotation_degrees(second);
    for (auto& row : matrix) row[3] = magnitude(1e-3, 1e6) * u(random);
    return Transform(matrix);
  }
  Ray ray() {
    const double far = magnitude(1e-3, 1e6), along = magnitude(1e-3, 1e3);
    return {{far * u(random), far * u(random), far * u(random)},
            {along * u(random), along * u(random), along * u(random)}};
  }
};

TEST(PlacedRay, ErrorsAreWithinTheirBounds) {
  RandomPlacing random;
  double largest_of_origin = 0, largest_of_direction = 0;
  int rays = 0;
  for (int i = 0; i < 2000; ++i) {
    const Transform transform = random.transform();
    for (int k = 0; k < 10; ++k, ++rays) {
      const Ray ray = random.ray();
      const PlacedRay placed(ray, transform);
      const double of_origin = largest_error(transform, placed.object().origin, ray.origin, 1) / placed.origin_error;
      const double of_direction =
          largest_error(transform, placed.object().direction, ray.direction, 0) / placed.direction_error;
      ASSERT_LE(of_origin, 1) << i;
      ASSERT_LE(of_direction, 1) << i;
      largest_of_origin = std::max(largest_of_origin, of_origin);
      largest_of_direction = std::max(largest_of_direction, of_direction);
    }
  }
  EXPECT_EQ(rays, 20000);
  EXPECT_GT(largest_of_origin, 0.2) << "the bound is not far off";
  EXPECT_GT(largest_of_direction, 0.2);
}

TEST(PlacedRay, DriftHoldsTheRayNearTheExactOne) {
  // Both rays at t, the exact one by o* = o' - error.
  RandomPlacing random;
  int points = 0;
  for (int i = 0; i < 5000; ++i) {
    const Transform transform = random.transform();
    const Ray ray = random.ray();
    const PlacedRay placed(ray, transform);
    const double of_origin = largest_error(transform, placed.object().origin, ray.origin, 1);
    const double of_direction = largest_error(transform, placed.object().direction, ray.direction, 0);
    for (const double t : {-2.0, 0.5, 1e3}) {
      const Point3 at = placed.object().at(t);
      const double reach = std::max({std::fabs(at.x), std::fabs(at.y), std::fabs(at.z)});
      ASSERT_LE(of_origin + std::fabs(t) * of_direction, placed.drift(reach)) << i;
      ++points;
    }
  }
  EXPECT_EQ(points, 15000);
}

TEST(PlacedRay, DriftIsInfiniteWhereTheDirectionHasNoDigits) {
  // The image of a direction that a nearly singular matrix takes from cancelling terms.
  const Transform transform({{{1, 1, 0, 0}, {1, 1 + 0x1p-52, 0, 0}, {0, 0, 1, 0}}});
  const Ray ray{{0, 0, 0}, {1, 1, 0}};
  PlacedRay placed(ray, transform);
  EXPECT_GT(placed.direction_error, 0.5) << "the inverse has entries of 2^52";
  EXPECT_EQ(placed.drift(1), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace plumb
