#pragma once

#include <cmath>
#include <stdexcept>

#include "renderer/math/vec3.h"

namespace plumb {

/// Throws std::invalid_argument unless both indices are positive and finite.
inline void require_indices(double from, double to) {
  if (!(from > 0 && to > 0 && std::isfinite(from) && std::isfinite(to)))
    throw std::invalid_argument("a refractive index is not positive and finite");
}

/// Likewise for the cosine, in [0, 1].
inline void require_interface(double cosine, double from, double to) {
  require_indices(from, to);
  if (!(cosine >= 0 && cosine <= 1)) throw std::invalid_argument("the cosine is not in [0, 1]");
}

inline void require_vectors(const Vec3& direction, const Vec3& normal) {
  if (!is_finite(direction) || !is_finite(normal) || direction == Vec3{} || normal == Vec3{})
    throw std::invalid_argument("the direction or the normal is zero or not finite");
}

inline const char* const kTowardsSurface = "the direction does not lead towards the surface";

}  // namespace plumb
