#pragma once

#include "conformance/families/aim.h"

namespace plumb {

Shape sphere_of(const Point3& center, double radius);
Shape box_of(const Point3& min, const Point3& max);
Shape cylinder_of(const Point3& center, double radius, double height);
Shape cone_of(const Point3& center, double radius, double height, double tip_z);

/// About as large as 1, not flat, the middle at most 2 away from zero in each coordinate; rounded.
Shape ordinary_sphere(Random& random, const Rounding& rounded);
Shape ordinary_box(Random& random, const Rounding& rounded);
Shape ordinary_cylinder(Random& random, const Rounding& rounded);
/// The tip lies beyond the kept part, above or below.
Shape ordinary_cone(Random& random, const Rounding& rounded);
/// The tip lies within the kept part.
Shape double_cone(Random& random, const Rounding& rounded);

/// A solid's middle, and the radius of a ball about it that holds the solid.
Point3 middle_of(const Shape& solid);
double reach_of(const Shape& solid);
/// The radius of a cylinder or cone at this z.
double radius_at(const Shape& solid, double z);

/// Strictly inside, at most 0.8 of the way from the middle to the surface (cones: away from
/// the tip by a tenth of the height).
Point3 inner_point(Random& random, const Shape& solid);
/// Where naive code leaks: on a rim of a cylinder or cone, on an edge or (one time in four) at a corner of a box,
/// anywhere on a sphere. Up to rounding.
Point3 rim_point(Random& random, const Shape& solid);
/// On any part of the surface, up to rounding; of cylinders and cones on the side or a cap.
Point3 surface_point(Random& random, const Shape& solid);
/// 2 to 4 reaches from the middle.
Point3 outside_origin(Random& random, const Shape& solid, const Rounding& rounded);
/// A target that a ray from the origin (outside_origin) passes the solid's ball to reach, by a tenth of it at least.
Point3 missed_target(Random& random, const Shape& solid, const Point3& origin);

/// Rays from outside, half of them at inner points, the others past it.
std::vector<Ray> control_rays(Random& random, const Shape& solid, const Rounding& rounded);

/// By how much the rounding of f = origin - centre (of a cone: - tip) is amplified in the first t >= t_min where the
/// ray meets a sphere, cylinder or cone: sum |g_i f_i| / (t |g.d|), g the gradient there of what the surface is a zero
/// of. In doubles, the worst of the rays; between 1 and largest_condition(). 1 for a miss, and for boxes, whose t is
/// one difference and one quotient.
double solid_condition(const Shape& solid, const std::vector<Ray>& rays, const Rounding& rounded);

/// The case with its solid_condition.
FamilyCase solid_case(const Shape& solid, std::vector<Ray> rays, const Rounding& rounded);

}  // namespace plumb
