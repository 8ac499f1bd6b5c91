#pragma once

#include "reference/exact_hit.h"
#include "reference/stage_counters.h"

namespace plumb {

/// exact_hit for sphere, box, cylinder and cone; `unsupported` for other kinds. A solid is a closed set S, and the
/// crossings are the ends of the maximal intervals of {t : origin + t direction in S}, so that passing from one nappe
/// of a cone to the other through the tip, inside all the way, is no crossing.
///
/// - An interval of positive length within the boundary (a line in a face, along a side, or any line in a solid without
///   interior) has two free ends, `boundary`. All other intervals of positive length have two proper ends.
/// - An interval that is one point is one crossing. It is free, and `tangent` if the side has a double root there (at a
///   rim too, and at a cone's tip), else `boundary`; but it is proper where the line runs through a box without
///   thickness or a cylinder or cone without height, and strictly inside of all its other limits.
/// - `part` is the lowest of the faces that hold the point.
/// - `inside`: strictly within all limits.
///
/// Every number is a function of the exact values alone, whence the paths agree bit for bit: t and each coordinate of
/// the position are rounded to nearest (ties to even, zero is +0); each coordinate of the normal is the multiple of
/// 2^-52 nearest to the exact one (ties to even), so within 2^-53. Where the side has no normal (the tip, and solids
/// without radius) the axis stands in: object space +z, for a cone the direction from its centre to its tip.
///
/// Adds one to the counter of the stage that decided: the polynomial one counts as `expansion`.
ExactHit solid_hit(const PlacedShape& shape, const Ray& ray, ExactPath path, StageCounters& counters);

}  // namespace plumb
