#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/accel/filter_ray.h"
#include "renderer/accel/searches_for_tests.h"

// How far the numbers of the float stage really are from the exact ones, beside the bounds that
// docs/certified-kernel.md derives.

namespace plumb {
namespace {

using Wide = std::array<long double, 3>;

Wide from_to(const Point3& o, const Point3& p) {
  return {static_cast<long double>(p.x) - o.x, static_cast<long double>(p.y) - o.y,
          static_cast<long double>(p.z) - o.z};
}
Wide cross(const Wide& p, const Wide& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}
long double dot(const Vec3& d, const Wide& p) { return d.x * p[0] + d.y * p[1] + d.z * p[2]; }

/// The largest share of each bound that was needed.
struct Needed {
  double weight = 0, depth = 0, interval = 0, margin = 0;
  int weights = 0, depths = 0, intervals = 0;
};

/// A triangle as the test of a leaf sees it, in the same operations, none of them fused; with its exact numbers in 64
/// bits, 2^40 times as close. The filter is given `rounded`, which is within its errors of the ray.
void measure(const Ray& ray, const PlacedRay& rounded, const FilterFrame& frame, const std::array<Point3, 3>& corners,
             Needed& needed) {
  FilterRay filter;
  BoxRay boxes;
  ASSERT_EQ(make_filter_ray(rounded, frame, filter, boxes), FilterRay::Fate::walk);
  const auto kz = filter.axis[2];
  std::array<float, 3> x, y, z;
  std::array<Wide, 3> exact;
  float sizes = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point3& p = corners[i];
    const auto from_origin = [&](int k) { return static_cast<float>(p[filter.axis[k]]) - filter.origin[k]; };
    z[i] = from_origin(2);
    x[i] = from_origin(0) - filter.shear[0] * z[i];
    y[i] = from_origin(1) - filter.shear[1] * z[i];
    sizes += std::fabs(x[i]) + std::fabs(y[i]);
    exact[i] = from_to(ray.origin, p);
  }
  const long double along = ray.direction[kz];
  const auto& [a, b, c] = exact;
  const std::array<long double, 3> weights{dot(ray.direction, cross(c, b)) / along,
                                           dot(ray.direction, cross(a, c)) / along,
                                           dot(ray.direction, cross(b, a)) / along};
  const float u = x[2] * y[1] - y[2] * x[1], v = x[0] * y[2] - y[0] * x[2], w = x[1] * y[0] - y[1] * x[0];
  const double error = double{sizes} * filter.weight_error + filter.weight_error_constant;
  for (std::size_t i = 0; i < 3; ++i, ++needed.weights)
    needed.weight =
        std::max(needed.weight, static_cast<double>(std::fabs(std::array{u, v, w}[i] - weights[i])) / error);

  const float det = (u + v) + w, area = std::fabs(det);
  const double area_error = 3.2 * error + area * 0x1p-21;
  const bool is_met = (weights[0] > 0) == (weights[1] > 0) && (weights[1] > 0) == (weights[2] > 0);
  if (!is_met || area <= area_error) return;
  ++needed.depths;
  const float t_a = z[0] * filter.reciprocal_z, zb = z[1] - z[0], zc = z[2] - z[0];
  const float rise = (det < 0 ? -1.0F : 1.0F) * ((v * zb + w * zc) * filter.reciprocal_z);
  const Wide normal = cross(from_to(corners[0], corners[1]), from_to(corners[0], corners[2]));
  const long double t = (a[0] * normal[0] + a[1] * normal[1] + a[2] * normal[2]) / dot(ray.direction, normal);
  const double rest = static_cast<double>(t - t_a);
  const double rise_error = error * double{std::fabs(zb) + std::fabs(zc)} * filter.reciprocal_size_z +
                            (area + 4.1 * error) * filter.depth_error;
  needed.depth = std::max(needed.depth, std::fabs(rest * area - rise) / (rise_error + std::fabs(rest) * area_error));
  if (area >= 2 * area_error) {
    ++needed.intervals;
    const float beyond_a = rise * (1 / area), middle = t_a + beyond_a;
    const double t_error = (std::fabs(beyond_a) * area_error + rise_error) * 2.001 / area;
    needed.interval = std::max(needed.interval, static_cast<double>(std::fabs(t - middle)) / t_error);
  }
  // Where it meets a side that it meets there, without margin.
  for (int axis = 0; axis < 3; ++axis) {
    const long double met = ray.origin[axis] + t * ray.direction[axis];
    const float reciprocal = boxes.reciprocal[axis], plane = static_cast<float>(met);
    const float origin = 0.5F * (boxes.near_origin[axis] + boxes.far_origin[axis]);
    const long double way = (plane * reciprocal - origin * reciprocal - t) / reciprocal - (plane - met);
    const double margin = 0.5 * std::fabs(double{boxes.near_origin[axis]} - double{boxes.far_origin[axis]});
    needed.margin = std::max(needed.margin, static_cast<double>(std::fabs(way)) / margin);
  }
}

/// Rays and vertices in floats; in doubles; and rays that were rounded by as much as their error says.
enum class Rays { floats, doubles, inaccurate };

Needed measured(Rays rays, unsigned seed) {
  const bool floats = rays == Rays::floats;
  SearchRandom u(seed);
  FilterFrame frame;
  frame.reach = 1;
  frame.vertex_error = floats ? 0 : 0x1p-25;  // half a unit of the last place, below 1
  set_filter_errors(frame);
  const auto given = [&](double x) { return floats ? static_cast<double>(static_cast<float>(x)) : x; };
  // Often close to a side or corner of the cube of this size.
  const auto point = [&](double size) {
    Point3 p;
    for (int axis = 0; axis < 3; ++axis)
      p[axis] = given(size * (u.below(2) ? u() : u.sign() * (1 - 0x1p-10 * std::fabs(u()))));
    return p;
  };
  Needed needed;
  for (int i = 0; i < 200000; ++i) {
    const Point3 a = point(1), b = point(1);
    // All sizes, as the bounds are shares of different things.
    const double size = std::ldexp(1.0, -static_cast<int>(u.below(12)));
    const Point3 near_a{given(a.x + size * (b.x - a.x)), given(a.y + size * (b.y - a.y)),
                        given(a.z + size * (b.z - a.z))};
    const Point3 c = a + 0.5 * size * u.vector();
    const Point3 third{given(std::clamp(c.x, -1.0, 1.0)), given(std::clamp(c.y, -1.0, 1.0)),
                       given(std::clamp(c.z, -1.0, 1.0))};
    const Point3 from = point(3.98);
    const double p = 0.25 * (1 + u()), q = 0.25 * (1 + u());
    Vec3 way = a + (p * (near_a - a) + q * (third - a)) - from;
    way = {given(way.x), given(way.y), given(way.z)};
    if (!(largest_coordinate(way) > 0x1p-20)) continue;
    const Ray ray{from, way};
    if (rays != Rays::inaccurate) {
      measure(ray, PlacedRay(ray), frame, {a, near_a, third}, needed);
      continue;
    }
    const double along = largest_coordinate(way);
    Ray rounded = ray;
    PlacedRay placed(rounded);
    placed.origin_error = std::ldexp(0.99, -static_cast<int>(u.below(30)));
    placed.direction_error = std::ldexp(0.99 * along, -12 - static_cast<int>(u.below(16)));
    for (int axis = 0; axis < 3; ++axis) {
      rounded.origin[axis] += u.sign() * placed.origin_error;
      rounded.direction[axis] += u.sign() * placed.direction_error;
    }
    if (largest_coordinate(rounded.origin) < 3.98) measure(ray, placed, frame, {a, near_a, third}, needed);
  }
  return needed;
}

/// The shares that are needed at least, or the bounds would not be tested here.
struct Expected {
  Rays rays;
  double weight, depth, interval, margin;
  int weights, depths, intervals;
};

TEST(FilterRay, NoNumberIsOffByMoreThanItsBound) {
  int kinds = 0;
  for (const auto& [rays, weight, depth, interval, margin, weights, depths, intervals] :
       {Expected{Rays::floats, 0.2, 0.1, 0.05, 0.2, 600000, 190000, 190000},
        {Rays::doubles, 0.2, 0.1, 0.05, 0.2, 600000, 190000, 190000},
        {Rays::inaccurate, 0.95, 0.5, 0.2, 0.99, 470000, 90000, 80000}}) {
    const Needed needed = measured(rays, 81);
    EXPECT_LE(needed.weight, 1) << kinds;
    EXPECT_LE(needed.depth, 1) << kinds;
    EXPECT_LE(needed.interval, 1) << kinds;
    EXPECT_LE(needed.margin, 1) << kinds;
    EXPECT_GT(needed.weight, weight) << kinds;
    EXPECT_GT(needed.depth, depth) << kinds;
    EXPECT_GT(needed.interval, interval) << kinds;
    EXPECT_GT(needed.margin, margin) << kinds;
    EXPECT_GE(needed.weights, weights) << kinds;
    EXPECT_GE(needed.depths, depths) << kinds;
    EXPECT_GE(needed.intervals, intervals) << kinds;
    ++kinds;
  }
  EXPECT_EQ(kinds, 3);
}

}  // namespace
}  // namespace plumb
