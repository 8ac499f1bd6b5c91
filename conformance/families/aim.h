#pragma once

#include "conformance/families/recipe.h"

namespace plumb {

inline Vec3 from_zero(const Point3& p) { return {p.x, p.y, p.z}; }
inline Point3 to_point(const Vec3& v) { return {v.x, v.y, v.z}; }
/// The largest magnitude of a coordinate.
double largest(const Vec3& v);

/// Unit length, even over the sphere.
Vec3 random_direction(Random& random);
/// Unit length, at right angles to `axis` (any length but zero), both up to rounding.
Vec3 random_perpendicular(Random& random, const Vec3& axis);
/// Unit length, in the plane of two axes.
Vec3 random_in_plane(Random& random, int axis_a, int axis_b);
/// Each coordinate between the two bounds.
Point3 random_point(Random& random, double low, double high);

/// The ray whose direction is the rounded way from the origin (representable already) to the target: what a careful
/// program would shoot. t is about 1 at the target. The z axis where both are the same.
Ray ray_to(const Point3& origin, const Point3& target, const Rounding& rounded);

/// A surface in world space and the rays at it.
FamilyCase case_of(Shape shape, std::vector<Ray> rays, double condition = 1);

}  // namespace plumb
