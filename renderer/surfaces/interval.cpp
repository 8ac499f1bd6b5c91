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
/// What a + b loses by rounding, given the rounded sum [Knuth 1997].
double lost(double a, double b, double sum) {
  const double from_b = sum - a;
  return (a - (sum - from_b)) + (b - from_b);
}

/// center + half - z with what both roundings lose, so that a ray that begins close to a cap, or within a flat solid,
/// does not see the rounding of the cap's height.
double distance_to_end(double center, double half, double z) {
  const double end = center + half;
  const double distance = end - z;
  if (!std::isfinite(distance)) return distance;
  return distance + (lost(center, half, end) + lost(end, -z, distance));
}

}  // namespace

std::optional<Interval> inside_slab(const Ray& ray, double center, double half) {
  const double to_bottom = distance_to_end(center, -half, ray.origin.z);
  const double to_top = distance_to_end(center, half, ray.origin.z);
  if (ray.direction.z == 0) {
    if (!(to_bottom <= 0 && to_top >= 0)) return std::nullopt;
    return Interval{{-kInfinity, kBottom}, {kInfinity, kTop}};
  }
  Crossing bottom{to_bottom / ray.direction.z, kBottom};
  Crossing top{to_top / ray.direction.z, kTop};
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

std::optional<Roots> quadratic_roots(const ExactSum& a, const ExactSum& b, const ExactSum& c) {
  const ExactSum discriminant = b * b - a * c;
  if (discriminant.sign() < 0) return std::nullopt;
  const long double middle = b.rounded();
  const long double q = middle + std::copysign(std::sqrt(discriminant.rounded()), middle);
  if (q == 0) return Roots{0, 0};
  const auto by_sum = static_cast<double>(q / a.rounded());
  const auto by_product = static_cast<double>(c.rounded() / q);
  return by_sum < by_product ? Roots{by_sum, by_product} : Roots{by_product, by_sum};
}

namespace {

std::optional<Interval> between(const std::optional<Roots>& roots) {
  if (!roots) return std::nullopt;
  return Interval{{roots->first, kSide}, {roots->second, kSide}};
}

/// Whether a point is, without rounding.
bool within_radius(const Point3& point, const Point3& center, double radius, int dimensions) {
  ExactSum c;
  for (int i = 0; i < dimensions; ++i) {
    const ExactSum f = ExactSum(point[i]) - center[i];
    c += f * f;
  }
  return c.add_product(-radius, radius).sign() <= 0;
}

std::optional<Interval> exactly_inside_radius(const Ray& ray, const Point3& center, double radius, int dimensions) {
  ExactSum a, b, c;
  for (int i = 0; i < dimensions; ++i) {
    const ExactSum f = ExactSum(ray.origin[i]) - center[i];
    a.add_product(ray.direction[i], ray.direction[i]);
    b -= f * ray.direction[i];
    c += f * f;
  }
  c.add_product(-radius, radius);
  return between(quadratic_roots(a, b, c));
}

}  // namespace

std::optional<Interval> inside_radius(const Ray& ray, const Point3& center, double radius, int dimensions) {
  Vec3 f = ray.origin - center;
  Vec3 d = ray.direction;
  if (dimensions == 2) f.z = d.z = 0;
  const double a = dot(d, d);
  const double squares = dot(f, f) + radius * radius;
  const double c = dot(f, f) - radius * radius;
  if (a == 0) {
    if (d != Vec3{}) {  // its square has underflowed
      return stretched(inside_radius({ray.origin, kStretch * d, ray.t_min / kStretch}, center, radius, dimensions));
    }
    const bool sure = std::fabs(c) > 0x1p-48 * squares;
    if (!(sure ? c <= 0 : within_radius(ray.origin, center, radius, dimensions))) return std::nullopt;
    return Interval{{-kInfinity, kSide}, {kInfinity, kSide}};
  }
  const double b = -dot(f, d);
  const Vec3 nearest = f + (b / a) * d;
  const double discriminant = radius * radius - dot(nearest, nearest);

  // The nearest point is off by 12u |f| at most and so, where it is about r away, the discriminant by 28u |f| r.
  const double size = std::fabs(f.x) + std::fabs(f.y) + std::fabs(f.z);
  const bool touches = std::fabs(discriminant) < 0x1p-46 * size * (radius + 0x1p-46 * size);
  // c is off by 8u of the squares, and c / b, about, is the root close to the origin. Before t_min it does not matter.
  const bool starts_at_surface =
      std::fabs(c) < 0x1p-20 * squares && !(std::fabs(c) + 0x1p-50 * squares < ray.t_min * std::fabs(b));
  if (touches || starts_at_surface) return exactly_inside_radius(ray, center, radius, dimensions);

  if (!(discriminant >= 0)) return std::nullopt;
  return between(quadratic_roots(a, b, c, a * discriminant));
}

}  // namespace plumb
