#pragma once

#include <limits>

#include "renderer/math/vec3.h"

namespace plumb {

/// An axis-aligned box, closed on all sides. The default one is empty (min > max on every axis).
struct Bounds3 {
  Point3 min{kInfinity, kInfinity, kInfinity};
  Point3 max{-kInfinity, -kInfinity, -kInfinity};

  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  /// Grows to hold `p`; a NaN coordinate is ignored.
  void extend(const Point3& p);
  /// Grows to hold `other`; an empty one changes nothing.
  void extend(const Bounds3& other);
  bool empty() const { return !(min.x <= max.x && min.y <= max.y && min.z <= max.z); }
  /// Whether `p` lies inside or on the surface.
  bool contains(const Point3& p) const;
  /// Half the surface area; 0 for an empty box.
  double half_area() const;
  /// The corner with maximal x, y, z where bit 0, 1, 2 of `index` is set, minimal elsewhere.
  Point3 corner(int index) const;
  Point3 center() const;

  friend bool operator==(const Bounds3&, const Bounds3&) = default;
};

}  // namespace plumb
