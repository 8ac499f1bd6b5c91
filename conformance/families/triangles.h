#pragma once

#include <array>

#include "conformance/families/aim.h"

namespace plumb {

using Vertices = std::array<Point3, 3>;

/// About as large as `size` around `center`, its area at least a fifth of its longest edge's square, rounded.
Vertices ordinary_triangle(Random& random, const Rounding& rounded, const Point3& center = {}, double size = 1);
/// Of the vertices as they stand; not of unit length.
Vec3 normal_of(const Vertices& triangle);
Point3 middle_of(const Vertices& triangle);
/// The point of the plane with these weights of the second and third vertex.
Point3 weighted(const Vertices& triangle, double v, double w);

/// Points of the plane, up to rounding. All weights at least 0.05:
Point3 inner_point(Random& random, const Vertices& triangle);
/// One weight at most -0.05, none beyond -2:
Point3 outer_point(Random& random, const Vertices& triangle);
/// Between two vertices, drawn evenly:
Point3 edge_point(Random& random, const Vertices& triangle);
/// Now an inner, now an outer point, every second time one on an edge or at a vertex.
Point3 any_point(Random& random, const Vertices& triangle);

/// At a distance of 1.5 to 4 sizes from the middle, from where the triangle is not seen edge-on (30 degrees at least).
Point3 facing_origin(Random& random, const Vertices& triangle, double size, const Rounding& rounded);

/// By how much the rounding of the edges e, of s = vertex - origin and of d is amplified in t = (s.n) / (d.n): the
/// larger of |d| |e|^2 / |d.n| and |s| |e|^2 / |s.n|, e the longest edge. The worst of the rays; between 1 and
/// largest_condition().
double triangle_condition(const Vertices& triangle, const std::vector<Ray>& rays, const Rounding& rounded);

/// The case with this condition, or with triangle_condition.
FamilyCase triangle_case(const Vertices& triangle, std::vector<Ray> rays, double condition);
FamilyCase triangle_case(const Vertices& triangle, std::vector<Ray> rays, const Rounding& rounded);

}  // namespace plumb
