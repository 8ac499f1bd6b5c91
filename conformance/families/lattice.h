#pragma once

#include "conformance/families/triangles.h"

namespace plumb {

/// Whole numbers from -reach to reach; never all zero. reach >= 1 is rounded down.
Vec3 lattice_vector(Random& random, double reach);
/// Whole numbers at right angles to `axis`, which are whole numbers of at most 2^20; not all zero, at most
/// 4 |axis|.
Vec3 lattice_perpendicular(Random& random, const Vec3& axis);

/// The triangle a, a + steps p, a + steps q of whole numbers: the points a + i p + j q of its plane are whole too, on
/// its boundary exactly or beside it.
struct LatticeTriangle {
  Vec3 a, p, q;
  int steps = 1;

  Vertices vertices() const { return {point(0, 0), point(steps, 0), point(0, steps)}; }
  Point3 point(int i, int j) const { return to_point(a + (double(i) * p + double(j) * q)); }
  /// On an edge or, one time in four, at a vertex.
  Point3 boundary_point(Random& random) const;
  Point3 inner_point(Random& random) const;
  /// At most a step outside of the triangle's parallelogram.
  Point3 near_point(Random& random) const;
};

/// With area; a, steps p and steps q at most `reach` (>= 16) a coordinate.
LatticeTriangle lattice_triangle(Random& random, double reach);

/// A square matrix of whole numbers whose rows have the length `length` and stand at right angles: `length` times a
/// rotation, made of a quaternion of whole numbers (Euler's parametrisation).
struct LatticeRotation {
  std::array<Vec3, 3> rows;
  double length = 1;
};
/// The quaternion's numbers are at most `reach`; the length is at most 4 reach^2.
LatticeRotation lattice_rotation(Random& random, double reach);

}  // namespace plumb
