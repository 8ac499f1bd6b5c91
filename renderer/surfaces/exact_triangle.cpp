#include "renderer/surfaces/exact_triangle.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace plumb {
namespace {

using ExactVector = std::array<Dyadic, 3>;

ExactVector cross(const ExactVector& p, const ExactVector& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

Dyadic dot(const ExactVector& p, const ExactVector& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }

ExactVector seen_from(const Point3& origin, const Transform* world_from_object, const Point3& p) {
  if (!world_from_object) return {Dyadic(p.x) - origin.x, Dyadic(p.y) - origin.y, Dyadic(p.z) - origin.z};
  const ExactVector object{p.x, p.y, p.z};
  ExactVector seen;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& row = world_from_object->matrix()[i];
    seen[i] = dot({row[0], row[1], row[2]}, object) + row[3] - origin[static_cast<int>(i)];
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

}  // namespace

ExactTriangle::ExactTriangle(const Ray& world, const Transform* world_from_object, const TriangleVertices& vertices) {
  const ExactVector a = seen_from(world.origin, world_from_object, vertices[0]);
  const ExactVector b = seen_from(world.origin, world_from_object, vertices[1]);
  const ExactVector c = seen_from(world.origin, world_from_object, vertices[2]);
  const ExactVector direction{world.direction.x, world.direction.y, world.direction.z};
  const ExactVector c_cross_b = cross(c, b);
  u_ = dot(direction, c_cross_b);
  v_ = dot(direction, cross(a, c));
  w_ = dot(direction, cross(b, a));
  sum_ = u_ + v_ + w_;
  numerator_ = dot(a, c_cross_b);
}

bool ExactTriangle::is_met() const {
  const auto [low, high] = std::minmax({u_.sign(), v_.sign(), w_.sign()});
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
