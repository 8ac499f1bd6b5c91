#pragma once

#include <array>
#include <cmath>

#include "tools/kernels/primitive_kernel.h"

namespace plumb::kernels {

/// Three numbers of a kernel's own precision.
template <class Real>
struct Triple {
  Real x, y, z;
  friend Triple operator-(const Triple& a, const Triple& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  Real operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
};
template <class Real>
Real dot(const Triple<Real>& a, const Triple<Real>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Real>
Triple<Real> cross(const Triple<Real>& a, const Triple<Real>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class Real, class From>
Triple<Real> triple(const From& p) {
  return {static_cast<Real>(p.x), static_cast<Real>(p.y), static_cast<Real>(p.z)};
}

/// A ray in a kernel's own precision, which its numbers have been promised to have.
template <class Real>
struct RealRay {
  explicit RealRay(const Ray& ray)
      : origin(triple<Real>(ray.origin)),
        direction(triple<Real>(ray.direction)),
        t_min(static_cast<Real>(ray.t_min)),
        t_max(static_cast<Real>(ray.t_max)) {}
  /// Whether t lies in the closed range and is a number that an answer may hold.
  bool contains(Real t) const { return t >= t_min && t <= t_max && std::isfinite(t); }

  Triple<Real> origin, direction;
  Real t_min, t_max;
};

/// The corners of a triangle, for the triangle kernels to test in their own ways.
template <class Derived, class Real>
struct Triangle {
  static void collect(const plumb_surface& from, std::uint32_t surface, std::vector<Derived>& triangles) {
    const plumb_mesh& mesh = from.mesh;
    const auto corner = [&](std::uint32_t vertex) {
      const double* p = mesh.positions + 3 * static_cast<std::size_t>(vertex);
      return Triple<Real>{static_cast<Real>(p[0]), static_cast<Real>(p[1]), static_cast<Real>(p[2])};
    };
    for (std::uint32_t i = 0; i < mesh.triangle_count; ++i) {
      const std::uint32_t* v = mesh.triangles + 3 * static_cast<std::size_t>(i);
      Derived triangle;
      triangle.surface = surface;
      triangle.index = i;
      triangle.corners = {corner(v[0]), corner(v[1]), corner(v[2])};
      triangles.push_back(triangle);
    }
  }

  Bounds3 bounds() const {
    Bounds3 box;
    for (const Triple<Real>& c : corners) box.extend(Point3{c.x, c.y, c.z});
    return box;
  }

  /// Some 2^4 times the precision's unit: what the tests' differences and shears may be off by.
  static constexpr double kMargin = sizeof(Real) == sizeof(float) ? 0x1p-20 : 0x1p-40;

  std::uint32_t surface = 0, index = 0;
  std::array<Triple<Real>, 3> corners{};
};

}  // namespace plumb::kernels
