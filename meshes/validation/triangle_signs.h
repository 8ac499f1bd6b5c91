#pragma once

#include "renderer/math/vec3.h"

namespace plumb {

/// Signs that are right for any finite numbers, however large, small or far apart: by doubles with an error bound where
/// that decides, else by ProductSum.

/// Whether three points lie on a line, or together.
bool on_a_line(const Point3& a, const Point3& b, const Point3& c);

/// The sign of normal . (b - a) x (c - a): 1 if the normal points to the side that sees a, b, c counter-clockwise, -1
/// if behind it, 0 along the triangle, and for a zero normal or three points on a line.
int side_of_normal(const Normal3& normal, const Point3& a, const Point3& b, const Point3& c);

}  // namespace plumb
