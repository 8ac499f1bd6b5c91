#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "conformance/envelopes/textbook/formulas.h"

namespace plumb::textbook {

enum class Shape { sphere, box, inverted_box, cylinder, cone };

/// A solid in its own frame. Cylinders and cones stand along z.
template <class A>
struct Solid {
  using Real = RealOf<A>;
  Shape shape = Shape::sphere;
  /// Of all but boxes.
  Vector<A> center;
  /// Of a cone, at the height of the centre.
  Real radius = 1;
  /// Of cylinders and cones: they reach from center.z - half_height to center.z + half_height.
  Real half_height = 0;
  /// Of a cone, the height of its tip.
  Real tip_z = 0;
  /// Of a box.
  Vector<A> min, max;

  /// How fast a cone's radius grows with the distance from its tip.
  Real slope() const { return radius / std::fabs(center.z - tip_z); }
};

/// Faces of round solids; those of boxes are 2 axis + (1 for the maximal one).
constexpr std::uint32_t kSide = 0, kBottom = 1, kTop = 2;

template <class A>
struct Crossing {
  RealOf<A> t;
  std::uint32_t face;
};

/// The entry if it lies in range, else the exit.
template <class A>
std::optional<Crossing<A>> meet_box(const Solid<A>& box, const Ray<A>& ray) {
  using Real = RealOf<A>;
  constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
  Crossing<A> enter{-kInfinity, 0}, leave{kInfinity, 0};
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    const Real o = ray.origin[axis], d = ray.direction[axis];
    if (d == 0) {
      if (!(o >= box.min[axis] && o <= box.max[axis])) return std::nullopt;
      continue;
    }
    Crossing<A> near{(box.min[axis] - o) / d, 2 * axis}, far{(box.max[axis] - o) / d, 2 * axis + 1};
    if (d < 0) std::swap(near, far);
    if (!(near.t <= far.t)) return std::nullopt;  // NaN
    if (near.t > enter.t) enter = near;
    if (far.t < leave.t) leave = far;
  }
  if (!(enter.t <= leave.t)) return std::nullopt;
  if (ray.contains(enter.t)) return enter;
  if (ray.contains(leave.t)) return leave;
  return std::nullopt;
}

/// What the course's slab loop answers for a box whose corners are the wrong way round; see docs/scene-format.md.
template <class A>
std::optional<Crossing<A>> meet_inverted_box(const Solid<A>& box, const Ray<A>& ray) {
  using Real = RealOf<A>;
  Real start = ray.t_min, end = ray.t_max;
  std::uint32_t axis_of_start = 0;
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    Real near = (box.min[axis] - ray.origin[axis]) / ray.direction[axis];
    Real far = (box.max[axis] - ray.origin[axis]) / ray.direction[axis];
    if (ray.direction[axis] < 0) std::swap(near, far);
    if (start > far || near > end) return std::nullopt;
    if (near > start) start = near, axis_of_start = axis;
    end = std::min(end, far);
  }
  return Crossing<A>{start, 2 * axis_of_start};
}

/// Where the line meets the endless side of a cylinder or cone.
template <class A>
std::optional<Roots<A>> side_roots(const Solid<A>& solid, const Ray<A>& ray, Formulas formulas) {
  using Real = RealOf<A>;
  const Vector<A> d = ray.direction;
  const Vector<A> f = ray.origin - solid.center;
  if (solid.shape == Shape::cylinder) return round_roots<A>({f.x, f.y, 0}, {d.x, d.y, 0}, solid.radius, formulas);
  const Real slope = solid.slope();
  return cone_roots<A>({f.x, f.y, slope * (ray.origin.z - solid.tip_z)}, {d.x, d.y, slope * d.z}, formulas);
}

/// The nearest of: the side where it lies between the caps, and the caps where they lie within the side.
template <class A>
std::optional<Crossing<A>> meet_capped(const Solid<A>& solid, const Ray<A>& ray, Formulas formulas) {
  using Real = RealOf<A>;
  std::optional<Crossing<A>> nearest;
  const auto offer = [&](Real t, std::uint32_t face) {
    if (ray.contains(t) && (!nearest || t < nearest->t)) nearest = Crossing<A>{t, face};
  };
  if (const auto roots = side_roots(solid, ray, formulas)) {
    for (const Real t : {roots->near, roots->far})
      if (std::fabs(ray.at(t).z - solid.center.z) <= solid.half_height) offer(t, kSide);
  }
  if (ray.direction.z == 0) return nearest;
  for (const std::uint32_t face : {kBottom, kTop}) {
    const Real z = face == kBottom ? solid.center.z - solid.half_height : solid.center.z + solid.half_height;
    const Real t = (z - ray.origin.z) / ray.direction.z;
    const Vector<A> p = ray.at(t) - solid.center;
    const Real radius = solid.shape == Shape::cone ? solid.slope() * (z - solid.tip_z) : solid.radius;
    if (p.x * p.x + p.y * p.y <= radius * radius) offer(t, face);
  }
  return nearest;
}

/// The smallest crossing in the ray's range, entry or exit; the ray in the solid's frame.
template <class A>
std::optional<Crossing<A>> meet_solid(const Solid<A>& solid, const Ray<A>& ray, Formulas formulas) {
  if (solid.shape == Shape::box) return meet_box(solid, ray);
  if (solid.shape == Shape::inverted_box) return meet_inverted_box(solid, ray);
  if (solid.shape != Shape::sphere) return meet_capped(solid, ray, formulas);
  const auto roots = round_roots(ray.origin - solid.center, ray.direction, solid.radius, formulas);
  if (!roots) return std::nullopt;
  for (const RealOf<A> t : {roots->near, roots->far})
    if (ray.contains(t)) return Crossing<A>{t, kSide};
  return std::nullopt;
}

/// The point of that face nearest to `p`, a point about there, but for inverted boxes, which keep `p`.
template <class A>
Vector<A> snapped(const Solid<A>& solid, Vector<A> p, std::uint32_t face) {
  using Real = RealOf<A>;
  if (solid.shape == Shape::inverted_box) return p;
  if (solid.shape == Shape::box) {
    p[face / 2] = face % 2 == 1 ? solid.max[face / 2] : solid.min[face / 2];
    return p;
  }
  Vector<A> out = p - solid.center;
  if (solid.shape != Shape::sphere) {
    if (face == kBottom) return {p.x, p.y, solid.center.z - solid.half_height};
    if (face == kTop) return {p.x, p.y, solid.center.z + solid.half_height};
    out.z = 0;
  }
  const Real length = std::sqrt(dot(out, out));
  if (length == 0) return p;
  const Real radius = solid.shape == Shape::cone ? solid.slope() * std::fabs(p.z - solid.tip_z) : solid.radius;
  const Vector<A> point = solid.center + radius / length * out;
  return solid.shape == Shape::sphere ? point : Vector<A>{point.x, point.y, p.z};
}

/// Outward, in the solid's frame, of any length.
template <class A>
Vector<A> solid_normal(const Solid<A>& solid, const Ray<A>& ray, const Crossing<A>& at) {
  if (solid.shape == Shape::box || solid.shape == Shape::inverted_box) {
    Vector<A> normal;
    normal[at.face / 2] = at.face % 2 == 1 ? 1 : -1;
    if (solid.shape == Shape::inverted_box && dot(normal, ray.direction) > 0) return -normal;
    return normal;
  }
  if (solid.shape != Shape::sphere && at.face != kSide) return {0, 0, at.face == kTop ? RealOf<A>(1) : RealOf<A>(-1)};
  const Vector<A> p = ray.at(at.t);
  const Vector<A> out = p - solid.center;
  if (solid.shape == Shape::sphere) return out;
  if (solid.shape == Shape::cylinder) return {out.x, out.y, 0};
  return {out.x, out.y, -solid.slope() * solid.slope() * (p.z - solid.tip_z)};
}

}  // namespace plumb::textbook
