#pragma once

#include <optional>

#include "reference/exact_optics.h"

namespace plumb {

/// A second way to exact_refracted, by the refracted angle and the part of the direction along the surface, total
/// reflection by the sign of a polynomial; at `bits` (at least 256) of precision, doubled until decided.
std::optional<Vec3> exact_refracted_by_angles(const Vec3& direction, const Vec3& normal, double from, double to,
                                              int bits);

}  // namespace plumb
