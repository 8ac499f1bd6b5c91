#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "renderer/math/vec3.h"

namespace plumb::textbook {

/// How a program reckons: its type of numbers, and whether it adds terms from the last to the first.
template <class Number, bool reversed>
struct Arithmetic {
  using Real = Number;
  static constexpr bool kReversed = reversed;
};

template <class A>
using RealOf = typename A::Real;

/// Three terms in the arithmetic's order.
template <class A>
RealOf<A> sum(RealOf<A> a, RealOf<A> b, RealOf<A> c) {
  return A::kReversed ? (c + b) + a : (a + b) + c;
}

/// Three numbers that serve as point, vector, normal and colour alike, as in many a textbook.
template <class A>
struct Vector {
  using Real = RealOf<A>;
  Real x = 0, y = 0, z = 0;

  template <class Triple>
  static Vector from(const Triple& v) {
    return {static_cast<Real>(v.x), static_cast<Real>(v.y), static_cast<Real>(v.z)};
  }
  static Vector from(const Color& c) { return from(Vec3{c.r, c.g, c.b}); }

  Real operator[](std::size_t axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  Real& operator[](std::size_t axis) { return axis == 0 ? x : axis == 1 ? y : z; }

  friend Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vector operator-(const Vector& a) { return {-a.x, -a.y, -a.z}; }
  friend Vector operator*(const Vector& a, const Vector& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
  friend Vector operator*(Real s, const Vector& a) { return {s * a.x, s * a.y, s * a.z}; }
  friend Real dot(const Vector& a, const Vector& b) { return sum<A>(a.x * b.x, a.y * b.y, a.z * b.z); }
  friend Vector cross(const Vector& a, const Vector& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
  friend Vector unit(const Vector& a) {
    const Real length = std::sqrt(dot(a, a));
    return {a.x / length, a.y / length, a.z / length};
  }
  friend Vector lower(const Vector& a, const Vector& b) {
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
  }
  friend Vector upper(const Vector& a, const Vector& b) {
    return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
  }
};

/// Points origin + t direction with t in [t_min, t_max]; the direction has any length.
template <class A>
struct Ray {
  using Real = RealOf<A>;
  Vector<A> origin, direction;
  Real t_min, t_max;

  Vector<A> at(Real t) const { return origin + t * direction; }
  /// False for NaN.
  bool contains(Real t) const { return t >= t_min && t <= t_max; }
};

}  // namespace plumb::textbook
