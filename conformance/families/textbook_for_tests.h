#pragma once

#include <array>
#include <cmath>
#include <utility>

#include "conformance/families/family.h"

/// The formulas of textbooks, for any number type: in float and double they are what the families are hard for, in 113
/// bits they are the referee. Used by tests alone.
namespace plumb::textbook {

__extension__ typedef __float128 Quad;

template <class Real>
struct Triple {
  Real x, y, z;
};
template <class Real>
Triple<Real> operator-(const Triple<Real>& a, const Triple<Real>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class Real>
Real dot(const Triple<Real>& a, const Triple<Real>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Real>
Triple<Real> cross(const Triple<Real>& a, const Triple<Real>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class Real, class Any>
Triple<Real> to(const Any& v) {
  return {static_cast<Real>(v.x), static_cast<Real>(v.y), static_cast<Real>(v.z)};
}

template <class Real>
Real magnitude(Real x) {
  return x < 0 ? -x : x;
}
template <class Real>
Real square_root(Real x) {
  return std::sqrt(x);
}
/// Two steps of Newton from the double: 53, 106, 113 bits. For what lies in the range of doubles.
template <>
inline Quad square_root(Quad x) {
  if (x == 0) return 0;
  Quad root = std::sqrt(static_cast<double>(x));
  for (int i = 0; i < 2; ++i) root = (root + x / root) / 2;
  return root;
}

/// A hit, its t, and how far the decision was from turning over: relative to its terms.
template <class Real>
struct Answer {
  bool hit = false;
  Real t = 0;
  Real margin = 1;
  void nearer(Real at, Real t_min) {
    if (!(at >= t_min) || (hit && t <= at)) return;
    hit = true;
    t = at;
  }
  void narrow(Real by) {
    if (magnitude(by) < margin) margin = magnitude(by);
  }
};

/// The ray in the number type; t_max is infinite in all families.
template <class Real>
struct Line {
  Triple<Real> o, d;
  Real t_min;
};
template <class Real>
Line<Real> line_of(const Ray& ray) {
  return {to<Real>(ray.origin), to<Real>(ray.direction), static_cast<Real>(ray.t_min)};
}

/// Moller and Trumbore's test; a determinant up to `epsilon` counts as parallel.
template <class Real>
Answer<Real> triangle(const std::array<Point3, 3>& vertices, const Line<Real>& line, Real epsilon = 0) {
  const Triple<Real> a = to<Real>(vertices[0]);
  const Triple<Real> e1 = to<Real>(vertices[1]) - a;
  const Triple<Real> e2 = to<Real>(vertices[2]) - a;
  const Triple<Real> p = cross(line.d, e2);
  const Real det = dot(e1, p);
  Answer<Real> answer;
  if (magnitude(det) <= epsilon) return answer;
  const Triple<Real> s = line.o - a;
  const Triple<Real> q = cross(s, e1);
  const Real u = dot(s, p) / det;
  const Real v = dot(line.d, q) / det;
  for (const Real weight : {u, v, 1 - u - v}) answer.narrow(weight);
  const bool inside = u >= 0 && v >= 0 && u + v <= 1;
  if (inside) {
    const Real t = dot(e2, q) / det;
    answer.narrow(t);
    answer.nearer(t, line.t_min);
  }
  return answer;
}

template <class Real>
Answer<Real> sphere(const Shape& shape, const Line<Real>& line) {
  const Triple<Real> f = line.o - to<Real>(shape.center);
  const Real r = static_cast<Real>(shape.radius);
  const Real a = dot(line.d, line.d);
  const Real b = dot(f, line.d);
  const Real c = dot(f, f) - r * r;
  const Real discriminant = b * b - a * c;
  Answer<Real> answer;
  if (discriminant < 0) return answer;
  const Real root = square_root(discriminant);
  answer.nearer((-b - root) / a, line.t_min);
  answer.nearer((-b + root) / a, line.t_min);
  return answer;
}

/// The discriminant by way of the point of the line that is nearest to the centre [Haines 2019].
template <class Real>
Answer<Real> precise_sphere(const Shape& shape, const Line<Real>& line) {
  const Triple<Real> f = line.o - to<Real>(shape.center);
  const Real r = static_cast<Real>(shape.radius);
  const Real a = dot(line.d, line.d);
  const Real b = dot(f, line.d);
  const Triple<Real> nearest{f.x - b / a * line.d.x, f.y - b / a * line.d.y, f.z - b / a * line.d.z};
  const Real discriminant = a * (r * r - dot(nearest, nearest));
  const Real c = dot(f, f) - r * r;
  Answer<Real> answer;
  answer.narrow(discriminant / (a * r * r));
  if (discriminant < 0) return answer;
  answer.narrow(c / (r * r));
  const Real q = -b + (b > 0 ? -square_root(discriminant) : square_root(discriminant));
  answer.nearer(c / q, line.t_min);
  answer.nearer(q / a, line.t_min);
  return answer;
}

/// Slabs by dividing; `careful` looks at zeros first.
template <class Real>
Answer<Real> box(const Shape& shape, const Line<Real>& line, bool careful, bool strict = false) {
  const std::array<Real, 3> o{line.o.x, line.o.y, line.o.z};
  const std::array<Real, 3> d{line.d.x, line.d.y, line.d.z};
  bool any = false, empty = false;
  Real enter = 0, leave = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Real low = static_cast<Real>(shape.min[static_cast<int>(i)]);
    const Real high = static_cast<Real>(shape.max[static_cast<int>(i)]);
    if (careful && d[i] == 0) {
      empty = empty || o[i] < low || o[i] > high;
      continue;
    }
    Real near = (low - o[i]) / d[i], far = (high - o[i]) / d[i];
    if (near > far) std::swap(near, far);
    if (!any || near > enter) enter = near;
    if (!any || far < leave) leave = far;
    any = true;
  }
  Answer<Real> answer;
  if (empty || !any) return answer;
  answer.narrow((leave - enter) / (magnitude(leave) + magnitude(enter) + 1));
  if (strict ? !(enter < leave) : !(enter <= leave)) return answer;
  answer.nearer(enter, line.t_min);
  answer.nearer(leave, line.t_min);
  return answer;
}

/// Side and caps each by itself. `slack` widens both (the referee's); without it both tests are strict.
template <class Real>
Answer<Real> round_solid(const Shape& shape, const Line<Real>& line, Real slack) {
  const bool cone = shape.kind == ShapeKind::cone;
  const Real half = static_cast<Real>(shape.height) / 2;
  const Real r = static_cast<Real>(shape.radius);
  const Triple<Real> f = line.o - to<Real>(shape.center);
  const Real tip = cone ? static_cast<Real>(shape.tip_z) - static_cast<Real>(shape.center.z) : 0;
  const Real slope = cone ? r / tip : 0;
  const Real bend = slope * slope;
  const Real g = f.z - tip;
  const Real a = line.d.x * line.d.x + line.d.y * line.d.y - bend * line.d.z * line.d.z;
  const Real b = f.x * line.d.x + f.y * line.d.y - bend * g * line.d.z;
  const Real c = f.x * f.x + f.y * f.y - (cone ? bend * g * g : r * r);
  const Real discriminant = b * b - a * c;
  Answer<Real> answer;
  if (!(discriminant < 0)) {
    const Real root = square_root(discriminant);
    for (const Real t : {(-b - root) / a, (-b + root) / a}) {
      const Real z = f.z + t * line.d.z;
      if (magnitude(z) - half < slack * (half + 1)) answer.nearer(t, line.t_min);
    }
  }
  for (const Real z : {-half, half}) {
    const Real t = (z - f.z) / line.d.z;
    const Real x = f.x + t * line.d.x, y = f.y + t * line.d.y;
    const Real widest = cone ? bend * (z - tip) * (z - tip) : r * r;
    if (x * x + y * y - widest < slack * (widest + 1)) answer.nearer(t, line.t_min);
  }
  return answer;
}

constexpr double kReferee = 1e-26;

/// By the referee's rules (in Quad), or as naive code does it.
template <class Real>
Answer<Real> intersect(const Shape& shape, const Line<Real>& line, bool referee) {
  switch (shape.kind) {
    case ShapeKind::triangle:
      return triangle<Real>(shape.vertices, line);
    case ShapeKind::sphere:
      return referee ? precise_sphere<Real>(shape, line) : sphere<Real>(shape, line);
    case ShapeKind::box:
      return box<Real>(shape, line, referee);
    default:
      return round_solid<Real>(shape, line, static_cast<Real>(referee ? kReferee : 0));
  }
}

/// The ray in object space, by adjugate over determinant.
template <class Real>
Line<Real> in_object_space(const AffineMatrix& m, const Line<Real>& line) {
  const auto e = [&](std::size_t r, std::size_t c) { return static_cast<Real>(m[r % 3][c % 3]); };
  Real inverse[3][3];
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) {
      inverse[c][r] = e(r + 1, c + 1) * e(r + 2, c + 2) - e(r + 1, c + 2) * e(r + 2, c + 1);
    }
  }
  const Real det = e(0, 0) * inverse[0][0] + e(0, 1) * inverse[1][0] + e(0, 2) * inverse[2][0];
  const auto apply = [&](const Triple<Real>& v) {
    const auto row = [&](int i) { return (inverse[i][0] * v.x + inverse[i][1] * v.y + inverse[i][2] * v.z) / det; };
    return Triple<Real>{row(0), row(1), row(2)};
  };
  const Triple<Real> offset{static_cast<Real>(m[0][3]), static_cast<Real>(m[1][3]), static_cast<Real>(m[2][3])};
  return {apply(line.o - offset), apply(line.d), line.t_min};
}

}  // namespace plumb::textbook
