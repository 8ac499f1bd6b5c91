#pragma once

#include <limits>

#include "renderer/math/vec3.h"

namespace plumb {

/// The points origin + t direction for t in the closed range [t_min, t_max]. The direction is not
/// assumed to have unit length, so that t keeps its meaning when the ray is taken to another frame.
struct Ray {
  Point3 origin;
  Vec3 direction;
  double t_min = 0;
  double t_max = std::numeric_limits<double>::infinity();

  constexpr Point3 at(double t) const { return origin + t * direction; }
  /// Whether t lies in the closed range; false for NaN.
  constexpr bool contains(double t) const { return t >= t_min && t <= t_max; }
};

}  // namespace plumb
