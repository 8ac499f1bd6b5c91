#pragma once

#include <array>
#include <cmath>

#include "renderer/math/transform.h"
#include "tools/kernels/triangle.h"

namespace plumb::kernels {

/// The two roots, in any order; NaN where there are none.
template <class Real>
struct Roots {
  Real first, second;
};

/// The quadratic formula as it stands in textbooks: b^2 - 4 a c loses the radius where the sphere is far.
struct TextbookForm {
  template <class Real>
  static Roots<Real> roots(const Triple<Real>& f, const Triple<Real>& d, Real radius) {
    const Real a = dot(d, d);
    const Real b = 2 * dot(f, d);
    const Real c = dot(f, f) - radius * radius;
    const Real root = std::sqrt(b * b - 4 * a * c);
    return {(-b - root) / (2 * a), (-b + root) / (2 * a)};
  }
};

/// The form of [Haines 2019]: the discriminant from the point of the line that is nearest to the centre, the root of
/// larger magnitude by a sum and the other by Vieta.
struct PreciseForm {
  template <class Real>
  static Roots<Real> roots(const Triple<Real>& f, const Triple<Real>& d, Real radius) {
    const Real a = dot(d, d);
    const Real b = -dot(f, d);
    const Real along = b / a;
    const Triple<Real> nearest{f.x + along * d.x, f.y + along * d.y, f.z + along * d.z};
    const Real discriminant = radius * radius - dot(nearest, nearest);
    const Real q = b + std::copysign(std::sqrt(a * discriminant), b);
    if (q == 0) return {q, q};  // the origin is the point of contact
    return {(dot(f, f) - radius * radius) / q, q / a};
  }
};

/// A sphere under a matrix, tested in its own frame with a direction that is not made unit again. The inverse is taken
/// in doubles and rounded to the kernel's precision.
template <class Real, class Form>
struct Sphere {
  struct PreparedRay : RealRay<Real> {
    using RealRay<Real>::RealRay;
  };

  static void collect(const plumb_surface& from, std::uint32_t surface, std::vector<Sphere>& spheres) {
    AffineMatrix matrix;
    for (std::size_t i = 0; i < 12; ++i) matrix[i / 4][i % 4] = from.world_from_object[i];
    const Transform world_from_object(matrix);
    Sphere sphere;
    sphere.surface = surface;
    sphere.center = {static_cast<Real>(from.center[0]), static_cast<Real>(from.center[1]),
                     static_cast<Real>(from.center[2])};
    sphere.radius = static_cast<Real>(from.radius);
    sphere.is_placed = !world_from_object.is_identity();
    for (std::size_t i = 0; i < 12; ++i)
      sphere.inverse[i] = static_cast<Real>(world_from_object.inverse_matrix()[i / 4][i % 4]);
    const Point3 c{from.center[0], from.center[1], from.center[2]};
    const Vec3 r{from.radius, from.radius, from.radius};
    sphere.box = world_from_object(Bounds3{c + -1.0 * r, c + r});
    spheres.push_back(sphere);
  }

  const Bounds3& bounds() const { return box; }

  template <class Report>
  void intersect(const PreparedRay& ray, Report&& report) const {
    const Triple<Real> origin = is_placed ? mapped(ray.origin, 1) : ray.origin;
    const Triple<Real> direction = is_placed ? mapped(ray.direction, 0) : ray.direction;
    const Roots<Real> roots = Form::roots(origin - center, direction, radius);
    const Real near = std::min(roots.first, roots.second);
    const Real far = std::max(roots.first, roots.second);
    if (ray.contains(near)) report(near, 0, 0);
    if (ray.contains(far) && far != near) report(far, 0, 0);
  }

  /// The textbook form errs by more for far spheres, and its hits beside the box are lost among many spheres.
  static constexpr double kMargin = sizeof(Real) == sizeof(float) ? 0x1p-18 : 0x1p-40;

  std::uint32_t surface = 0, index = 0;

 private:
  Triple<Real> mapped(const Triple<Real>& p, Real w) const {
    const auto row = [&](std::size_t i) {
      return inverse[i] * p.x + inverse[i + 1] * p.y + inverse[i + 2] * p.z + inverse[i + 3] * w;
    };
    return {row(0), row(4), row(8)};
  }

  Triple<Real> center{};
  Real radius = 0;
  bool is_placed = false;
  std::array<Real, 12> inverse{};
  Bounds3 box;
};

constexpr plumb_contract sphere_contract(plumb_precision precision) {
  return {.precision = static_cast<std::uint32_t>(precision),
          .t_precision = static_cast<std::uint32_t>(precision),
          .culling = PLUMB_CULL_NONE,
          .edge_rule = PLUMB_EDGE_NONE,
          .range = PLUMB_RANGE_CLOSED,
          .inside = PLUMB_INSIDE_HITS_EXIT,
          .shapes = PLUMB_SPHERES,
          .capabilities = PLUMB_TRANSFORMS | PLUMB_THREAD_SAFE,
          .largest = 0};
}

}  // namespace plumb::kernels
