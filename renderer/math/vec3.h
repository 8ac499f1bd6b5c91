#pragma once

#include <cmath>

namespace plumb {

/// Four kinds of double triple. They are distinct types so that the wrong rule does not compile: a
/// Transform moves a Point3, turns a Vec3 and carries a Normal3 by the inverse transpose.
/// Default-constructed triples are zero. NaN and infinity pass through every operation.

/// A displacement or direction; not assumed to have unit length.
struct Vec3 {
  double x = 0, y = 0, z = 0;
  constexpr double operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  constexpr double& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
  friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
};

/// A position.
struct Point3 {
  double x = 0, y = 0, z = 0;
  constexpr double operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  constexpr double& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
  friend constexpr bool operator==(const Point3&, const Point3&) = default;
};

/// A direction perpendicular to a surface; not assumed to have unit length.
struct Normal3 {
  double x = 0, y = 0, z = 0;
  constexpr double operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  constexpr double& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
  friend constexpr bool operator==(const Normal3&, const Normal3&) = default;
};

/// Linear red, green and blue; not clamped.
struct Color {
  double r = 0, g = 0, b = 0;
  friend constexpr bool operator==(const Color&, const Color&) = default;
};

constexpr Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
constexpr Vec3 operator*(double s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
constexpr Vec3 operator/(const Vec3& a, double s) { return {a.x / s, a.y / s, a.z / s}; }

constexpr Point3 operator+(const Point3& p, const Vec3& v) { return {p.x + v.x, p.y + v.y, p.z + v.z}; }
constexpr Vec3 operator-(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

constexpr Normal3 operator+(const Normal3& a, const Normal3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Normal3 operator*(double s, const Normal3& a) { return {s * a.x, s * a.y, s * a.z}; }
constexpr Normal3 operator-(const Normal3& a) { return {-a.x, -a.y, -a.z}; }

constexpr Color operator+(const Color& a, const Color& b) { return {a.r + b.r, a.g + b.g, a.b + b.b}; }
constexpr Color operator*(double s, const Color& a) { return {s * a.r, s * a.g, s * a.b}; }
constexpr Color operator*(const Color& a, const Color& b) { return {a.r * b.r, a.g * b.g, a.b * b.b}; }
constexpr Color& operator+=(Color& a, const Color& b) { return a = a + b; }

constexpr double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr double dot(const Normal3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline double length(const Vec3& v) { return std::sqrt(dot(v, v)); }
/// A vector of unit length along `v`; NaN components for the zero vector.
inline Vec3 normalized(const Vec3& v) { return v / length(v); }

/// The same three numbers as a direction, where a formula mixes normals with vectors.
constexpr Vec3 as_vector(const Normal3& n) { return {n.x, n.y, n.z}; }
constexpr Normal3 as_normal(const Vec3& v) { return {v.x, v.y, v.z}; }
/// A normal of unit length along `n`; NaN components for the zero normal.
inline Normal3 normalized(const Normal3& n) { return as_normal(normalized(as_vector(n))); }

template <class Triple>
bool is_finite(const Triple& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
inline bool is_finite(const Color& c) { return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b); }

}  // namespace plumb
