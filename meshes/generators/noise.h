#pragma once

#include <cstdint>

#include "renderer/math/vec3.h"

namespace plumb {

/// Gradient noise [Perlin 1985] of five octaves, each of twice the frequency and half the height of the one before:
/// a smooth function of space without periods, within -3 and 3 and mostly within -0.5 and 0.5. |coordinates| < 2^40.
double noise(const Point3& at, std::uint64_t seed);

}  // namespace plumb
