#include "renderer/surfaces/surface.h"

#include <cmath>

namespace plumb {

Vec3 disc_extent(const AffineMatrix& m, double radius) {
  const auto row = [&](std::size_t i) { return radius * std::sqrt(m[i][0] * m[i][0] + m[i][1] * m[i][1]); };
  return {row(0), row(1), row(2)};
}

Bounds3 bounds_around(const Point3& center, const Vec3& extent, const Vec3& center_rounding) {
  Bounds3 box{center + -1.0 * extent, center + extent};
  for (int axis = 0; axis < 3; ++axis) {
    const double margin = center_rounding[axis] + 8 * 0x1p-53 * (std::fabs(center[axis]) + extent[axis]);
    box.min[axis] -= margin;
    box.max[axis] += margin;
  }
  return box;
}

}  // namespace plumb
