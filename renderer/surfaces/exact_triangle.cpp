#include "renderer/surfaces/exact_triangle.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

namespace plumb {
namespace {

template <class Number>
using Triple = std::array<Number, 3>;

template <class Number>
auto cross(const Triple<Number>& p, const Triple<Number>& q) {
  return std::array{p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

template <class Number, class Other>
auto dot(const Triple<Number>& p, const Triple<Other>& q) {
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}

template <class Number>
struct Determinants {
  Number u, v, w;
};

/// The three weights, and the numerator of t.
template <class Number, class Other>
auto determinants(const Triple<Number>& a, const Triple<Number>& b, const Triple<Number>& c,
                  const Triple<Other>& direction) {
  const auto c_cross_b = cross(c, b);
  auto u = dot(direction, c_cross_b);
  return std::pair(Determinants<decltype(u)>{u, dot(direction, cross(a, c)), dot(direction, cross(b, a))},
                   dot(a, c_cross_b));
}

Triple<Dyadic> seen_from(const Point3& origin, const Transform* world_from_object, const Point3& p) {
  if (!world_from_object) return {Dyadic(p.x) - origin.x, Dyadic(p.y) - origin.y, Dyadic(p.z) - origin.z};
  const Triple<Dyadic> object{p.x, p.y, p.z};
  Triple<Dyadic> seen;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& row = world_from_object->matrix()[i];
    seen[i] = dot(Triple<Dyadic>{row[0], row[1], row[2]}, object) + row[3] - origin[static_cast<int>(i)];
  }
  return seen;
}

/// a / b to nearest, ties to even; b is not zero.
double rounded_quotient(const Dyadic& a, const Dyadic& b) {
  // Each number is off by 2^-62 of itself, and the quotient by 2^-64.
  const long double about = a.rounded() / b.rounded();
  const auto low = static_cast<double>(about * (1 - 0x1p-60L)), high = static_cast<double>(about * (1 + 0x1p-60L));
  if (low == high || std::isinf(low) || std::isinf(high)) return static_cast<double>(about);
  // The middle between two doubles is within the interval.
  const int side = ((Dyadic(low) + high) * b - a * 2).sign() * b.sign();
  if (side == 0) return std::bit_cast<std::uint64_t>(low) % 2 == 0 ? low : high;
  return (side < 0) == (low < high) ? high : low;
}

template <class Vector>
void add_bits(BitSpan& bits, const Vector& v) {
  for (int axis = 0; axis < 3; ++axis) bits.add(v[axis]);
}

template <class Vector>
Triple<WideInteger<2>> whole(const Vector& v, int unit) {
  return {WideInteger<2>(v.x, unit), WideInteger<2>(v.y, unit), WideInteger<2>(v.z, unit)};
}

/// Two digits hold 127 bits and a sign; three are for sums.
constexpr int kTwoDigits = 124;
/// A power that a double holds, as do those of the numbers themselves.
constexpr int kLargestExponent = 960;

bool fits(const BitSpan& bits) {
  return bits.empty() || (bits.above - bits.lowest <= kTwoDigits && std::abs(bits.lowest) <= kLargestExponent);
}

/// The unit of numbers that may all be zero.
int unit_of(const BitSpan& bits) { return bits.empty() ? 0 : bits.lowest; }

}  // namespace

/// Whole numbers of few digits, in units of the lowest bits.
bool ExactTriangle::decide_by_integers(const Ray& world, const TriangleVertices& vertices) {
  BitSpan points, directions;
  add_bits(points, world.origin);
  for (const Point3& vertex : vertices) add_bits(points, vertex);
  add_bits(directions, world.direction);
  if (!fits(points) || !fits(directions)) return false;
  const int unit = unit_of(points);
  const Triple<WideInteger<2>> origin = whole(world.origin, unit);
  const auto seen = [&](const Point3& p) {
    const Triple<WideInteger<2>> v = whole(p, unit);
    return Triple<WideInteger<2>>{v[0] - origin[0], v[1] - origin[1], v[2] - origin[2]};
  };
  take(determinants(seen(vertices[0]), seen(vertices[1]), seen(vertices[2]),
                    whole(world.direction, unit_of(directions))),
       unit, unit_of(directions));
  return true;
}

/// The same with a matrix: products of two such numbers, of four digits, in units of both.
bool ExactTriangle::decide_by_integers(const Ray& world, const AffineMatrix& matrix, const TriangleVertices& vertices) {
  BitSpan points, entries, offsets, directions;
  for (const Point3& vertex : vertices) add_bits(points, vertex);
  for (const auto& row : matrix) {
    for (std::size_t column = 0; column < 3; ++column) entries.add(row[column]);
    offsets.add(row[3]);
  }
  add_bits(offsets, world.origin);
  add_bits(directions, world.direction);
  if (points.empty() || entries.empty()) return false;
  if (!offsets.empty()) entries.lowest = std::min(entries.lowest, offsets.lowest - points.lowest);
  const int unit = points.lowest + entries.lowest;
  if (!fits(points) || !fits(entries) || !fits(directions) || std::abs(unit) > kLargestExponent ||
      (!offsets.empty() && offsets.above - unit > 2 * kTwoDigits))
    return false;
  Triple<Triple<WideInteger<2>>> rows;
  Triple<WideInteger<4>> shift;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& row = matrix[i];
    rows[i] = whole(Vec3{row[0], row[1], row[2]}, entries.lowest);
    shift[i] = WideInteger<4>(row[3], unit) - WideInteger<4>(world.origin[static_cast<int>(i)], unit);
  }
  const auto seen = [&](const Point3& p) {
    const Triple<WideInteger<2>> v = whole(p, points.lowest);
    return Triple<WideInteger<4>>{dot(rows[0], v) + shift[0], dot(rows[1], v) + shift[1], dot(rows[2], v) + shift[2]};
  };
  take(determinants(seen(vertices[0]), seen(vertices[1]), seen(vertices[2]),
                    whole(world.direction, unit_of(directions))),
       unit, unit_of(directions));
  return true;
}

template <class Weights>
void ExactTriangle::take(const Weights& weights_and_numerator, int point_unit, int direction_unit) {
  const auto& [weights, numerator] = weights_and_numerator;
  signs_ = {weights.u.sign(), weights.v.sign(), weights.w.sign()};
  if (!is_met()) return;
  // t = T / D, where T has one unit of points more, and D one of directions.
  v_ = Dyadic(weights.v, direction_unit);
  w_ = Dyadic(weights.w, direction_unit);
  sum_ = Dyadic(weights.u + weights.v + weights.w, direction_unit);
  numerator_ = Dyadic(numerator, point_unit);
}

ExactTriangle::ExactTriangle(const Ray& world, const Transform* world_from_object, const TriangleVertices& vertices,
                             Numbers numbers) {
  if (numbers == Numbers::shortest &&
      (world_from_object ? decide_by_integers(world, world_from_object->matrix(), vertices)
                         : decide_by_integers(world, vertices)))
    return;
  const auto [weights, numerator] = determinants(
      seen_from(world.origin, world_from_object, vertices[0]), seen_from(world.origin, world_from_object, vertices[1]),
      seen_from(world.origin, world_from_object, vertices[2]),
      Triple<Dyadic>{world.direction.x, world.direction.y, world.direction.z});
  signs_ = {weights.u.sign(), weights.v.sign(), weights.w.sign()};
  v_ = weights.v;
  w_ = weights.w;
  sum_ = weights.u + weights.v + weights.w;
  numerator_ = numerator;
}

bool ExactTriangle::is_met() const {
  const auto [low, high] = std::minmax({signs_[0], signs_[1], signs_[2]});
  return low != -high;  // else on different sides, or all zero
}

int ExactTriangle::compare_t(double tau) const {
  if (std::isinf(tau)) return tau > 0 ? -1 : 1;
  return (numerator_ - sum_ * tau).sign() * sum_.sign();
}

int ExactTriangle::compare_t(const ExactTriangle& other) const {
  return (numerator_ * other.sum_ - other.numerator_ * sum_).sign() * sum_.sign() * other.sum_.sign();
}

double ExactTriangle::t() const { return rounded_quotient(numerator_, sum_); }
double ExactTriangle::weight_b() const { return rounded_quotient(v_, sum_); }
double ExactTriangle::weight_c() const { return rounded_quotient(w_, sum_); }

}  // namespace plumb
