#include "renderer/accel/filter_ray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <random>

#include "meshes/generators/icosphere.h"
#include "renderer/accel/bvh8.h"
#include "renderer/accel/searches_for_tests.h"
#include "renderer/surfaces/exact_triangle.h"

namespace plumb {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kRays = 1000;
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
        BoxRay boxes;
        ASSERT_EQ(make_filter_ray(PlacedRay(ray), frame, filter, boxes), FilterRay::Fate::walk);
        EXPECT_EQ(std::fabs(d[static_cast<std::size_t>(filter.axis[2])]), 1) << d[0] << ' ' << d[1] << ' ' << d[2];
        EXPECT_LE(std::fabs(filter.shear[0]), 1);
        EXPECT_LE(std::fabs(filter.shear[1]), 1);
        const ShearedRay sheared(ray);
        EXPECT_EQ(std::fabs(d[static_cast<std::size_t>(sheared.kz)]), 1) << d[0] << ' ' << d[1] << ' ' << d[2];
        // The numbers of a hit are computed along the filter's axes, to the bits of those along these.
        EXPECT_EQ(filter.axis[0], sheared.kx) << d[0] << ' ' << d[1] << ' ' << d[2];
        EXPECT_EQ(filter.axis[1], sheared.ky) << d[0] << ' ' << d[1] << ' ' << d[2];
        EXPECT_EQ(filter.axis[2], sheared.kz) << d[0] << ' ' << d[1] << ' ' << d[2];
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

/// A ray at a vertex, an edge, a corner's neighbourhood or the inside of a triangle of a mesh of this size around the
/// origin: along the triangle's plane, in few digits so that it meets exactly, from near and from far, with coordinates
/// of any smallness, of any length.
class AimedRay {
 public:
  AimedRay(const TriangleMesh& mesh, const Point3& center, double size, SearchRandom& u) : u_(u), size_(size) {
    const auto& [i, j, k] = mesh.triangles[u.below(mesh.triangles.size())];
    const Point3 &a = mesh.positions[i], &b = mesh.positions[j], &c = mesh.positions[k];
    Vec3 way = way_to(a, b, c);
    for (std::size_t small = u.below(4); small < 2; ++small) way[static_cast<int>(u.below(3))] *= power(-45, 0);
    Point3 from = target(a, b, c) + -1.0 * way;
    way = power(-29, 29) / size * way;
    if (u.below(2)) {
      from = center + in_floats(from - center);
      way = in_floats(way);
    }
    ray_ = {from, way};
  }
  const Ray& ray() const { return ray_; }

 private:
  double power(int low, int high) {
    return std::ldexp(1.0, low + static_cast<int>(u_.below(static_cast<std::size_t>(high - low + 1))));
  }
  Vec3 in_floats(const Vec3& v) { return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)}; }
  double share() { return 0.5 * (1 + u_()); }
  Vec3 in_few_digits() {
    const auto number = [&] { return std::round(32 * u_()) / 32; };
    const double x = number(), y = number();
    return {x, y, number()};
  }

  Point3 target(const Point3& a, const Point3& b, const Point3& c) {
    switch (u_.below(5)) {
      case 0:
        return a;
      case 1:
        return a + std::round(8 * share()) / 8 * (b - a);
      case 2:
        return a + share() * (c - a);
      case 3:  // a few floats beside a corner
        return b + power(-26, -20) * (size_ * in_few_digits());
      default:
        return a + (0.5 * share() * (b - a) + 0.5 * share() * (c - a));
    }
  }
  Vec3 way_to(const Point3& a, const Point3& b, const Point3& c) {
    switch (u_.below(6)) {
      case 0:
        return size_ * in_few_digits();
      case 1:  // in the plane or nearly so
        return u_() * (b - a) + u_() * (c - a) + power(-60, 0) * u_.vector(size_);
      case 2:
        return u_.vector(power(0, 45) * size_);
      case 3:  // from about as far as is still near
        return u_.vector(4 * size_);
      default:
        return u_.vector(power(-20, 3) * size_);
    }
  }

  SearchRandom& u_;
  double size_;
  Ray ray_;
};

/// Asks for the whole range, and for ranges that end and begin where the hit is said to be, and just before and behind.
void compare_with_cuts(SearchComparison& compare, Ray ray, const Transform& transform, int& cut) {
  const auto ask = [&] { return compare(PlacedRay(ray, transform)); };
  const auto hit = ask();
  if (!hit) return;
  const double t = hit->t, before = std::nextafter(t, -kInfinity), behind = std::nextafter(t, kInfinity);
  for (const auto& [low, high] :
       {std::pair(0.0, t), {0.0, before}, {0.0, behind}, {t, kInfinity}, {behind, kInfinity}, {t, t}}) {
    if (low > high) continue;
    ray.t_min = low;
    ray.t_max = high;
    ask();
    ++cut;
  }
}

// All that the bounds must cover, on meshes of few triangles: what is passed by wrongly is a hit, or the cut of a
// range, that the search through all triangles finds.
TEST(FilterRay, LosesNoTriangleToTheHardestRays) {
  SearchRandom u(72);
  TriangleMesh needles;
  for (int i = 0; i < 30; ++i) {
    const Point3 p = u.point();
    const Vec3 along = u.vector();
    add_triangle(needles, p, p + along, p + (0.5 * along + u.vector(1e-5)));
  }
  const std::vector<TriangleMesh> shapes{
      icosphere(1),           moved(cube_of_squares(-1, 2), 0.75, {}), triangle_soup(u, 40, 1),
      triangle_soup(u, 1, 2), triangle_soup(u, 40, 0x1p-10),           needles};
  struct Place {
    double size;
    Vec3 offset;
  };
  const std::vector<Place> places{{1, {}},         {1, {3, -2, 0.5}}, {1, {1000, 30, -500}}, {0x1p-19, {}},
                                  {0x1.8p-29, {}}, {0x1.8p24, {}},    {0x1.8p29, {}},        {1e-60, {}}};
  SearchTally sum;
  int cut = 0, placed = 0;
  for (const TriangleMesh& shape : shapes) {
    for (const auto& [size, offset] : places) {
      for (const bool floats : {true, false}) {
        TriangleMesh mesh = moved(shape, size, offset);
        if (floats) mesh = in_single_precision(mesh);
        SearchComparison compare(mesh);
        for (int i = 0; i < kRays; ++i) {
          Ray ray = AimedRay(mesh, Point3{} + offset, size, u).ray();
          Transform transform;
          if (i % 3 == 0) {
            transform = Transform(turned(u, std::pow(10.0, 3 * (1 + u())), 10 * size * u()));
            const Point3 from = transform(ray.origin);
            ray = {from, transform(ray.at(1)) - from};
            ++placed;
          }
          compare_with_cuts(compare, ray, transform, cut);
        }
        sum += compare.tally();
      }
    }
  }
  EXPECT_EQ(sum.rays - cut, 6 * 8 * 2 * kRays);
  EXPECT_GT(sum.rays, 300000);
  EXPECT_GT(sum.hits, 150000);
  EXPECT_EQ(placed, 6 * 8 * 2 * ((kRays + 2) / 3));
  EXPECT_EQ(sum.different, 0);
}

// A small mesh and a long direction: depths times weights must not fall below the smallest float.
TEST(FilterRay, LosesNoSmallTriangleAtTheEndOfALongRaysRange) {
  SearchRandom u(73);
  SearchTally sum;
  int cut = 0;
  for (const double size : {0x1.2p-30, 0x1.4p-30, 0x1.8p-30}) {
    for (int k = 0; k < 100; ++k) {
      const TriangleMesh mesh = in_single_precision(moved(triangle_soup(u, 20, std::ldexp(1.0, -7 - k % 2)), size, {}));
      SearchComparison compare(mesh);
      for (int i = 0; i < 200; ++i) {
        const auto& [a, b, c] = mesh.triangles[u.below(20)];
        const Point3 target = mesh.positions[a] + (0.25 * (mesh.positions[b] - mesh.positions[a]) +
                                                   0.5 * (mesh.positions[c] - mesh.positions[a]));
        const Vec3 way = u.vector(size);
        compare_with_cuts(compare, {target + -1.0 * way, 0x1.fp29 / largest_coordinate(way) * way}, Transform(), cut);
      }
      sum += compare.tally();
    }
  }
  EXPECT_EQ(sum.rays - cut, 60000);
  EXPECT_GT(cut, 300000);
  EXPECT_EQ(sum.different, 0);
}

}  // namespace
}  // namespace plumb
