#pragma once

#include <algorithm>
#include <optional>

#include "conformance/envelopes/textbook/arithmetic.h"

namespace plumb::textbook {

/// Where textbooks have two formulas for one thing, which of them a program has.
///
/// | what | usual | other |
/// | --- | --- | --- |
/// | transforms | multiplied to one matrix | applied one after the other (scene.h) |
/// | spheres, cylinders | half the chord about the nearest point [Haines 2019] | a t^2 + 2 b t + c = 0 by its
/// discriminant | | cones | the discriminant by minors, roots that do not cancel | the same | | where a ray hits | put
/// onto the surface | origin + t direction | | triangles | [Moller 1997] | the plane, then areas | | interpolated
/// normals | weighted sum of three | the first and two differences | | camera rays | of unit length | to the view
/// window | | reflectance | parallel and perpendicular part [Shirley 13.1] | [Cook 1982] | | refraction | along the
/// normal and the ray | along the normal and the tangent |
enum class Formulas { usual, other };

template <class A>
struct Roots {
  RealOf<A> near, far;
};

/// The roots of a t^2 + 2 b t + c = 0, a not zero, in order; none if they are not real.
template <class A>
std::optional<Roots<A>> quadratic_roots(RealOf<A> a, RealOf<A> b, RealOf<A> c) {
  using Real = RealOf<A>;
  const Real discriminant = b * b - a * c;
  if (!(discriminant >= 0)) return std::nullopt;
  const Real root = std::sqrt(discriminant);
  const Real first = (-b - root) / a, second = (-b + root) / a;
  return Roots<A>{std::min(first, second), std::max(first, second)};
}

/// Where f + t d lies at distance `radius` from the origin. Half the chord keeps its digits far from a small sphere,
/// where b b and a c are large and nearly equal: in single precision the usual quadratic equation makes acne.
template <class A>
std::optional<Roots<A>> round_roots(const Vector<A>& f, const Vector<A>& d, RealOf<A> radius, Formulas formulas) {
  using Real = RealOf<A>;
  const Real dd = dot(d, d);
  if (!(dd > 0)) return std::nullopt;
  if (formulas == Formulas::other) return quadratic_roots<A>(dd, dot(f, d), dot(f, f) - radius * radius);
  const Real middle = -dot(f, d) / dd;
  const Vector<A> nearest = f + middle * d;
  const Real half_squared = radius * radius - dot(nearest, nearest);
  if (!(half_squared >= 0)) return std::nullopt;
  const Real half = std::sqrt(half_squared / dd);
  return Roots<A>{middle - half, middle + half};
}

/// Where f + t d lies on the double cone x x + y y = z z. The discriminant as a sum of squares of minors does not
/// cancel where the origin is far; b b - a c does.
template <class A>
std::optional<Roots<A>> cone_roots(const Vector<A>& f, const Vector<A>& d, Formulas formulas) {
  using Real = RealOf<A>;
  const Real a = sum<A>(d.x * d.x, d.y * d.y, -d.z * d.z);
  const Real b = sum<A>(f.x * d.x, f.y * d.y, -f.z * d.z);
  const Real c = sum<A>(f.x * f.x, f.y * f.y, -f.z * f.z);
  if (a == 0) return b != 0 ? std::optional(Roots<A>{-c / (2 * b), -c / (2 * b)}) : std::nullopt;
  if (formulas == Formulas::other) return quadratic_roots<A>(a, b, c);
  const Vector<A> minors = cross(f, d);
  const Real discriminant = sum<A>(minors.x * minors.x, minors.y * minors.y, -minors.z * minors.z);
  if (!(discriminant >= 0)) return std::nullopt;
  // The root that does not cancel, and the other one by the product of both.
  const Real q = b > 0 ? -b - std::sqrt(discriminant) : -b + std::sqrt(discriminant);
  if (q == 0) return Roots<A>{0, 0};
  return Roots<A>{std::min(q / a, c / q), std::max(q / a, c / q)};
}

/// Where a ray meets a triangle: its parameter, and the weights of the second and third vertex.
template <class A>
struct TriangleCrossing {
  RealOf<A> t, u, v;
};

/// Both sides count, and the edges.
template <class A>
std::optional<TriangleCrossing<A>> meet_triangle(const Vector<A>& p0, const Vector<A>& p1, const Vector<A>& p2,
                                                 const Ray<A>& ray, Formulas formulas) {
  using Real = RealOf<A>;
  const Vector<A> e1 = p1 - p0, e2 = p2 - p0;
  Real t, u, v;
  if (formulas == Formulas::usual) {
    const Vector<A> across = cross(ray.direction, e2);
    const Real determinant = dot(e1, across);
    if (determinant == 0) return std::nullopt;
    const Vector<A> from = ray.origin - p0;
    u = dot(from, across) / determinant;
    if (!(u >= 0 && u <= 1)) return std::nullopt;
    const Vector<A> along = cross(from, e1);
    v = dot(ray.direction, along) / determinant;
    t = dot(e2, along) / determinant;
  } else {
    const Vector<A> normal = cross(e1, e2);
    const Real slope = dot(normal, ray.direction);
    if (slope == 0) return std::nullopt;
    t = dot(normal, p0 - ray.origin) / slope;
    const Vector<A> p = ray.at(t);
    const Real area = dot(normal, normal);
    u = dot(cross(p0 - p2, p - p2), normal) / area;
    v = dot(cross(p1 - p0, p - p0), normal) / area;
  }
  if (!(u >= 0 && v >= 0 && u + v <= 1) || !ray.contains(t)) return std::nullopt;
  return TriangleCrossing<A>{t, u, v};
}

}  // namespace plumb::textbook
