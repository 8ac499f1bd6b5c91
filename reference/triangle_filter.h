#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "renderer/math/ray.h"
#include "renderer/math/transform.h"

namespace plumb {

/// The determinants that decide between a ray and a triangle, in doubles with error bounds.
///
/// A, B, C are the vertices seen from the ray's origin, d is its direction:
///   U = d.(C x B) = C.(B x d)    V = d.(A x C)    W = d.(B x A) = -A.(B x d)    T = A.(C x B) = B.(A x C)
/// U, V, W are the weights of A, B and C in the point that is hit, times D = U + V + W; t = T / D.
///
/// The bounds. u = 2^-53; M is the largest |coordinate| of the computed A, B, C, each within E of the exact one; L = M
/// + E; |d| = |d_x| + |d_y| + |d_z|. By the standard model fl(x op y) = (x op y)(1 + delta), |delta| <= u [Higham 2002,
/// section 2.2]; gamma_n = n u / (1 - n u).
/// - Each of U, V, W is a sum of six products of three factors: product, difference, product, two sums, so five
///   roundings on each. The six magnitudes add up to at most 2 |d| M^2. That is gamma_5 2 |d| M^2, below 10.1 u |d|
///   L^2.
/// - With exact instead of computed A, B, C each product moves by at most |d_i| ((M + E)^2 - M^2) <= 2 |d_i| L E: in
/// all
///   4 |d| L E.
///   So |error| <= |d| L (10.1 u L + 4 E). `weight_bound` = |d| L (12 u L + 5 E), whose own six roundings lose less
///   than 7 u of it.
/// - T likewise: the six magnitudes add up to at most 6 M^3, moved by 6 (L^3 - M^3) <= 18 L^2 E:
///   |error| <= L^2 (30.1 u L + 18 E).
/// - D adds two roundings, on at most 6.1 |d| L^2: |error| <= 3 weight_bound + 12.3 u |d| L^2 < 4.1 weight_bound.
/// - T - tau D for a bound tau of the range: the product rounds by u |tau D|, the difference by u (|T| + |tau D|), with
///   |T| <= 6.1 L^3 and |D| <= 6.1 |d| L^2: |error| <= L^2 (36.3 u L + 18 E) + |tau| (4.1 weight_bound + 12.3 u |d|
///   L^2)
///   <= `t_bound` + 6 |tau| weight_bound with t_bound = L^2 (40 u L + 20 E); the last of these roundings lose less than
///   10 u of it.
/// Underflow. M and |d| are held within [2^-200, 2^200], so nothing overflows but T - tau D (then the bound is infinite
/// too, and nothing is decided). A product that underflows is off by 2^-1075 more, and reaches the result times at most
/// 2^200 (twelve of them: below 2^-870), where the slack of the bounds, at least 1.8 u |d| L^2 or 3 u L^3, is above
/// 2^-653.
/// Not a number. Any two of U, V, W depend on all inputs; so whatever is decided was decided from finite numbers.
struct TriangleEstimate {
  double u = 0, v = 0, w = 0, t = 0;
  /// How far u, v, w, and t are off at most. Infinite where the bound does not hold.
  double weight_bound = std::numeric_limits<double>::infinity();
  double t_bound = std::numeric_limits<double>::infinity();
};

/// Vertices seen from the ray's origin; each coordinate is within `error` of the exact one.
struct SeenTriangle {
  Vec3 a, b, c;
  double largest = 0;
  double error = 0;
};

namespace triangle_filter {

inline constexpr double kUnit = 0x1p-53;
inline constexpr double kSmallest = 0x1p-200;
inline constexpr double kLargest = 0x1p200;

inline double max_norm(const Vec3& v) { return std::max(std::max(std::abs(v.x), std::abs(v.y)), std::abs(v.z)); }
inline double sum_norm(const Vec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }
inline double max_norm(const Vec3& a, const Vec3& b, const Vec3& c) {
  return std::max(std::max(max_norm(a), max_norm(b)), max_norm(c));
}

}  // namespace triangle_filter

/// A triangle in world space: each difference rounds once.
inline SeenTriangle seen_triangle(const Point3& origin, const Point3& a, const Point3& b, const Point3& c) {
  using namespace triangle_filter;
  SeenTriangle seen{a - origin, b - origin, c - origin};
  seen.largest = max_norm(seen.a, seen.b, seen.c);
  seen.error = kUnit * seen.largest;
  return seen;
}

/// The same of triangles under an affine map, m v + (translation - origin). On the way of a coordinate there are at
/// most four roundings, on magnitudes that add up to at most S = row_sum |v| + offset: gamma_4 S. 8 u S also covers the
/// rounding of S, and underflows, for S is held above 2^-200.
class MappedTriangles {
 public:
  MappedTriangles(const AffineMatrix& world_from_object, const Point3& origin) : m_(world_from_object) {
    for (int i = 0; i < 3; ++i) {
      const auto& row = m_[static_cast<std::size_t>(i)];
      row_sum_ = std::max(row_sum_, std::abs(row[0]) + std::abs(row[1]) + std::abs(row[2]));
      offset_ = std::max(offset_, std::abs(row[3]) + std::abs(origin[i]));
      shift_[i] = row[3] - origin[i];
    }
  }

  SeenTriangle operator()(const Point3& a, const Point3& b, const Point3& c) const {
    using namespace triangle_filter;
    SeenTriangle seen{map(a), map(b), map(c)};
    seen.largest = max_norm(seen.a, seen.b, seen.c);
    constexpr Point3 kOrigin;
    const double size = row_sum_ * max_norm(a - kOrigin, b - kOrigin, c - kOrigin) + offset_;
    seen.error = size >= kSmallest ? 8 * kUnit * size : std::numeric_limits<double>::infinity();
    return seen;
  }

 private:
  Vec3 map(const Point3& p) const {
    Vec3 result;
    for (int i = 0; i < 3; ++i) {
      const auto& row = m_[static_cast<std::size_t>(i)];
      result[i] = row[0] * p.x + row[1] * p.y + row[2] * p.z + shift_[i];
    }
    return result;
  }

  AffineMatrix m_;
  Vec3 shift_;
  double row_sum_ = 0;
  double offset_ = 0;
};

inline TriangleEstimate estimate_triangle(const SeenTriangle& seen, const Vec3& direction) {
  using namespace triangle_filter;
  TriangleEstimate result;
  const Vec3 turned = cross(seen.b, direction);
  const Vec3 side = cross(seen.a, seen.c);
  result.u = dot(seen.c, turned);
  result.w = -dot(seen.a, turned);
  result.v = dot(direction, side);
  result.t = dot(seen.b, side);
  const double length = sum_norm(direction);
  const double reach = seen.largest + seen.error;
  if (reach >= kSmallest && reach <= kLargest && length >= kSmallest && length <= kLargest) {
    result.weight_bound = length * reach * (12 * kUnit * reach + 5 * seen.error);
    result.t_bound = reach * reach * (40 * kUnit * reach + 20 * seen.error);
  }
  return result;
}

/// What an estimate proves. A hit is a proper one, strictly inside of triangle and range.
enum class FilterVerdict { undecided, miss, hit };

inline FilterVerdict judge_estimate(const TriangleEstimate& estimate, double t_min, double t_max) {
  const double low = std::min(std::min(estimate.u, estimate.v), estimate.w);
  const double high = std::max(std::max(estimate.u, estimate.v), estimate.w);
  const double bound = estimate.weight_bound;
  if (!(t_min <= t_max)) return FilterVerdict::undecided;
  if (low < -bound && high > bound) return FilterVerdict::miss;
  if (!(low > bound || high < -bound)) return FilterVerdict::undecided;
  const double sign = low > 0 ? 1 : -1;
  const double t = sign * estimate.t;
  const double d = sign * (estimate.u + estimate.v + estimate.w);
  // How surely t lies above a bound of the range: 1, -1, or 0 for undecided.
  const auto side_of = [&](double tau) {
    if (std::isinf(tau)) return tau < 0 ? 1 : -1;
    const double difference = t - tau * d;
    const double error = estimate.t_bound + 6 * std::abs(tau) * bound;
    return difference > error ? 1 : difference < -error ? -1 : 0;
  };
  const int above_min = side_of(t_min);
  const int above_max = side_of(t_max);
  if (above_min < 0 || above_max > 0) return FilterVerdict::miss;
  return above_min > 0 && above_max < 0 ? FilterVerdict::hit : FilterVerdict::undecided;
}

}  // namespace plumb
