#pragma once

#include <array>

#include "renderer/math/vec3.h"

namespace plumb {

/// A right-handed orthonormal frame u, v, w with w along `direction`, which has any finite length but zero (NaN
/// components for others). Lengths differ from 1, and products of two of them from 0, by 4 * 2^-53 at most. Not
/// continuous in the direction, as no such frame is.
std::array<Vec3, 3> frame_about(const Vec3& direction);

}  // namespace plumb
