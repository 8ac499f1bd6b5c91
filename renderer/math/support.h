#pragma once

#include "renderer/math/exact_sum.h"
#include "renderer/math/transform.h"

namespace plumb {

/// How far a body reaches in a direction: the maximum over its points p of row . (p, 1), where a row of an affine
/// matrix gives the coordinate on one axis of the mapped body. All results are the smallest double that is not below
/// the exact one, as long as every number that comes in is zero or within [2^-120, 2^120] in magnitude; outside of that
/// range they are not below it, and a few units of 2^-53 of the largest term above it at most.
using AffineRow = std::array<double, 4>;

/// Of one point.
double highest(const AffineRow& row, const Point3& point);

/// Of a box that is not empty: of the corner that the signs of the row choose.
double highest(const AffineRow& row, const Bounds3& box);

/// A ball, or a disc about the z axis, with a radius of radius * |numerator / denominator|.
struct RoundBody {
  Point3 center;
  double radius = 0;
  /// 3 for a ball, 2 for a disc.
  std::size_t dimensions = 3;
  /// By how much the centre is moved along z; a sum of two doubles need not be one.
  double shift = 0;
  ExactSum numerator = 1, denominator = 1;
};
double highest(const AffineRow& row, const RoundBody& body);

/// An upper bound for every point of the box, off by roundings: to find out quickly that there is nothing higher there.
double about_highest(const AffineRow& row, const Bounds3& box);

/// The smallest box, in doubles, of a mapped body; `highest_of(row)` is one of the functions above or their maximum.
template <class HighestOf>
Bounds3 mapped_bounds(const AffineMatrix& matrix, const HighestOf& highest_of) {
  Bounds3 bounds;
  for (int axis = 0; axis < 3; ++axis) {
    const AffineRow& row = matrix[static_cast<std::size_t>(axis)];
    bounds.max[axis] = highest_of(row);
    bounds.min[axis] = 0.0 - highest_of(AffineRow{-row[0], -row[1], -row[2], -row[3]});
  }
  return bounds;
}

}  // namespace plumb
