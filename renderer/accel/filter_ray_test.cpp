#include "renderer/accel/filter_ray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <random>

#include "renderer/accel/bvh8.h"
#include "renderer/surfaces/exact_triangle.h"

namespace plumb {
namespace {

constexpr std::array<std::array<int, 3>, 6> kOrders{{{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};

// Every bound of the weights rests on shears of at most 1.
TEST(FilterRay, ShearsAlongTheLongestAxis) {
  FilterFrame frame;
  frame.reach = 1;
  set_filter_errors(frame);
  int rays = 0;
  for (const auto& order : kOrders) {
    for (const double middle : {0.0, 0.25, 0.75, 1.0}) {
      for (const double least : {0.0, 0x1p-20, 0.125, 1.0}) {
        if (least > middle) continue;
        std::array<double, 3> d{};
        d[static_cast<std::size_t>(order[0])] = -1;
        d[static_cast<std::size_t>(order[1])] = middle;
        d[static_cast<std::size_t>(order[2])] = -least;
        const Ray ray{{0.5, 0.25, 2}, {d[0], d[1], d[2]}};
        FilterRay filter;
        ASSERT_EQ(make_filter_ray(ray, {}, frame, filter), FilterRay::Fate::walk);
        EXPECT_EQ(std::fabs(d[filter.axis[2]]), 1) << d[0] << ' ' << d[1] << ' ' << d[2];
        EXPECT_LE(std::fabs(filter.shear_x), 1);
        EXPECT_LE(std::fabs(filter.shear_y), 1);
        const ShearedRay sheared(ray);
        EXPECT_EQ(std::fabs(d[static_cast<std::size_t>(sheared.kz)]), 1) << d[0] << ' ' << d[1] << ' ' << d[2];
        EXPECT_LE(std::fabs(sheared.shear_x), 1);
        EXPECT_LE(std::fabs(sheared.shear_y), 1);
        ++rays;
      }
    }
  }
  EXPECT_EQ(rays, 6 * 11);
}

// Directions of every order of sizes, the least down to 2^-40 of the largest, aimed at vertices and edges.
TEST(FilterRay, LosesNoTriangleWhateverTheOrderOfTheDirection) {
  std::mt19937_64 random(71);
  std::uniform_real_distribution<double> u(-1, 1);
  const auto number = [&] { return u(random); };
  int met = 0, lost = 0;
  for (const auto& order : kOrders) {
    for (int exponent = 0; exponent <= 40; exponent += 8) {
      for (int i = 0; i < 500; ++i) {
        auto mesh = std::make_shared<TriangleMesh>();
        for (int k = 0; k < 3; ++k) {
          const double x = number(), y = number(), z = number();
          mesh->positions.push_back({x, y, z});
        }
        mesh->triangles = {{0, 1, 2}};
        std::array<double, 3> d{};
        d[static_cast<std::size_t>(order[0])] = number() < 0 ? -1 : 1;
        d[static_cast<std::size_t>(order[1])] = number();
        d[static_cast<std::size_t>(order[2])] = std::ldexp(d[static_cast<std::size_t>(order[1])] * number(), -exponent);
        const Vec3 direction{d[0], d[1], d[2]};
        const Point3 &a = mesh->positions[0], &b = mesh->positions[1], &c = mesh->positions[2];
        const Ray ray{a + (i % 2) * 0.5 * (1 + number()) * (b - a) + -direction, direction};
        const ExactTriangle exact(ray, nullptr, {a, b, c}, ExactTriangle::Numbers::dyadic);
        if (!exact.is_met() || exact.compare_t(0) < 0) continue;
        ++met;
        TraceCounters counters;
        if (Bvh8(mesh).closest(PlacedRay(ray), counters)) continue;
        if (lost++ == 0)
          ADD_FAILURE() << std::hexfloat << "lost: " << a.x << ' ' << a.y << ' ' << a.z << ", " << b.x << ' ' << b.y
                        << ' ' << b.z << ", " << c.x << ' ' << c.y << ' ' << c.z << " by " << ray.origin.x << ' '
                        << ray.origin.y << ' ' << ray.origin.z << " + t " << d[0] << ' ' << d[1] << ' ' << d[2];
      }
    }
  }
  EXPECT_EQ(lost, 0);
  EXPECT_GT(met, 5000);
}

}  // namespace
}  // namespace plumb
