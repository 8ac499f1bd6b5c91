#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "renderer/math/exact_sum.h"
#include "renderer/math/ray.h"

namespace plumb {

/// The solids are intersected as intervals of the ray's line: those inside the side, cut with those inside the
/// slab. Separate tests of side and caps would leak at the rim.

/// The end of an interval: where, and on which part of the solid.
struct Crossing {
  double t;
  std::uint32_t part;
};

/// Closed; from <= to.
struct Interval {
  Crossing from;
  Crossing to;
};

/// Up to two disjoint intervals in rising order.
struct Intervals {
  std::array<Interval, 2> items;
  int count = 0;
};

/// The parts of a solid around the z axis.
enum SolidPart : std::uint32_t { kSide = 0, kBottom = 1, kTop = 2 };

/// Where center - half <= z <= center + half; a t has the sign of the exact one. Nothing if the line runs outside of
/// the slab, parallel to it.
std::optional<Interval> inside_slab(const Ray& ray, double center, double half);

/// The part of `a` in `b`; on equal ends the crossing of `a` is kept.
std::optional<Interval> intersection(const Interval& a, const Interval& b);

/// The smallest crossing within the ray's range, or nothing.
std::optional<Crossing> first_crossing(const Intervals& intervals, const Ray& ray);

/// The roots of a t^2 - 2 b t + c = 0 in rising order, given the discriminant b^2 - a c >= 0 from a form that
/// does not cancel, and a != 0. The larger root in magnitude comes from a sum, the other from c by Vieta.
struct Roots {
  double first, second;
};
Roots quadratic_roots(double a, double b, double c, double discriminant);

/// The same from coefficients without rounding, each root within 2^-60 of itself before it is rounded to a double, so
/// that its sign is right. Nothing if the discriminant is negative.
std::optional<Roots> quadratic_roots(const ExactSum& a, const ExactSum& b, const ExactSum& c);

/// Where the line lies within `radius` of the centre, by its first two coordinates (a cylinder) or by all three (a
/// ball). The discriminant is taken as r^2 - |f - (f.d / d.d) d|^2, with f from the centre to the origin, which stays
/// accurate far away [Haines 2019]. Where its sign is not sure, or that of a root because the origin is close to the
/// surface, exact coefficients decide; for that every number must be zero or within [2^-190, 2^190].
std::optional<Interval> inside_radius(const Ray& ray, const Point3& center, double radius, int dimensions);

}  // namespace plumb
