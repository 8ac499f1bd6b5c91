#pragma once

#include <array>
#include <cstdint>

#include "reference/shape.h"
#include "renderer/math/bounds3.h"

namespace plumb {

/// The smallest doubles box that holds the placed shape: on each axis the exact minimum rounded down and the exact
/// maximum rounded up. Empty for a mesh without triangles (unused vertices do not count). Throws std::invalid_argument
/// for a shape outside of the oracle's domain; a singular matrix is fine.
Bounds3 exact_bounds(const PlacedShape& shape);

/// How a claimed box stands to the shape, decided exactly (no rounding, square roots by comparing squares).
struct BoundsVerdict {
  /// The closed box holds every point of the shape.
  bool contains = false;
  /// For each face (min x, y, z, max x, y, z): how many doubles it lies outside of the tightest face that still
  /// contains; 0 is tight; negative if it cuts into the shape by as many. Saturates at +-2^62.
  std::array<std::int64_t, 6> ulps_loose{};
  /// Likewise as a distance over the largest of |coordinate| and extent of the shape: of the loosest face, or negative
  /// of the face that cuts in deepest if one does; for people.
  double relative_looseness = 0;
};
/// A box with NaN, or empty around a shape that is not, contains nothing. Any empty box is tight around an empty shape.
/// Throws like exact_bounds.
BoundsVerdict judge_bounds(const PlacedShape& shape, const Bounds3& claimed);
/// The same by the second path (rationals and CGAL's roots instead of homogeneous polynomials).
BoundsVerdict judge_bounds_rational(const PlacedShape& shape, const Bounds3& claimed);

}  // namespace plumb
