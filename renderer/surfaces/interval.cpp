#include "renderer/surfaces/interval.h"

#include <cmath>
#include <limits>
#include <utility>

namespace plumb {
namespace {
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A power of two, so that stretching a direction and its t by it is exact.
constexpr double kStretch = 0x1p600;

std::optional<Interval> stretched(std::optional<Interval> interval) {
  if (!interval) return interval;
  return Interval{{interval->from.t * kStretch, interval->from.part}, {interval->to.t * kStretch, interval->to.part}};
}
}  // namespace

std::optional<Interval> inside_slab(const Ray& ray, double center, double half) {
  const double low = center - half;
  const double high = center + half;
  if (ray.direction.z == 0) {
    if (!(ray.origin.z >= low && ray.origin.z <= high)) return std::nullopt;
    return Interval{{-kInfinity, kBottom}, {kInfinity, kTop}};
  }
  Crossing bottom{(low - ray.origin.z) / ray.direction.z, kBottom};
  Crossing top{(high - ray.origin.z) / ray.direction.z, kTop};
  if (ray.direction.z < 0) std::swap(bottom, top);
  if (!(bottom.t <= top.t)) return std::nullopt;  // NaN
  return Interval{bottom, top};
}

std::optional<Interval> intersection(const Interval& a, const Interval& b) {
  const Crossing from = b.from.t > a.from.t ? b.from : a.from;
  const Crossing to = b.to.t < a.to.t ? b.to : a.to;
  if (!(from.t <= to.t)) return std::nullopt;
  return Interval{from, to};
}

std::optional<Crossing> first_crossing(const Intervals& intervals, const Ray& ray) {
  for (int i = 0; i < intervals.count; ++i) {
    const Interval& interval = intervals.items[static_cast<std::size_t>(i)];
    if (ray.contains(interval.from.t) && std::isfinite(interval.from.t)) return interval.from;
    if (ray.contains(interval.to.t) && std::isfinite(interval.to.t)) return interval.to;
  }
  return std::nullopt;
}

Roots quadratic_roots(double a, double b, double c, double discriminant) {
  const double q = b + std::copysign(std::sqrt(discriminant), b);
  if (q == 0) return {0, 0};
  const double by_sum = q / a;
  const double by_product = c / q;
  return by_sum < by_product ? Roots{by_sum, by_product} : Roots{by_product, by_sum};
}

std::optional<Interval> inside_radius(const Vec3& f, const Vec3& d, double radius) {
  const double a = dot(d, d);
  const double c = dot(f, f) - radius * radius;
  if (a == 0) {
    if (d != Vec3{}) return stretched(inside_radius(f, kStretch * d, radius));  // its square has underflowed
    if (!(c <= 0)) return std::nullopt;
    return Interval{{-kInfinity, kSide}, {kInfinity, kSide}};
  }
  const double b = -dot(f, d);
  const Vec3 nearest = f + (b / a) * d;
  const double discriminant = radius * radius - dot(nearest, nearest);
  if (!(discriminant >= 0)) return std::nullopt;
  const Roots roots = quadratic_roots(a, b, c, a * discriminant);
  return Interval{{roots.first, kSide}, {roots.second, kSide}};
}

}  // namespace plumb
