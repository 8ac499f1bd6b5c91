#pragma once

#include <cmath>

#include "conformance/kernel/plumb_kernel.h"
#include "renderer/math/transform.h"
#include "renderer/math/vec3.h"

namespace plumb {

/// The nearest float. Not inline on purpose: of `double(float(x))` for two neighbouring numbers, GCC 12's vectoriser
/// (from -O2 on) makes a copy without the rounding. The tests show it where it happens.
double nearest_float(double x);

/// Rounds to the precision of a family, to nearest: what it returns is representable there.
class Rounding {
 public:
  explicit Rounding(plumb_precision precision) : is_float_(precision == PLUMB_FLOAT) {}

  bool is_float() const { return is_float_; }
  /// Half the distance from 1 to the next number.
  double unit_roundoff() const { return is_float_ ? 0x1p-24 : 0x1p-53; }
  /// The largest condition that is worth stating: beyond it no digit of the answer is determined.
  double largest_condition() const { return 0.125 / unit_roundoff(); }
  /// One of two parameters, by precision.
  double pick(double for_float, double for_double) const { return is_float_ ? for_float : for_double; }

  /// The next representable number from x (representable) towards `goal`.
  double next(double x, double goal) const {
    return is_float_ ? static_cast<double>(std::nextafter(static_cast<float>(x), static_cast<float>(goal)))
                     : std::nextafter(x, goal);
  }

  double operator()(double x) const { return is_float_ ? nearest_float(x) : x; }
  Point3 operator()(const Point3& p) const { return {(*this)(p.x), (*this)(p.y), (*this)(p.z)}; }
  Vec3 operator()(const Vec3& v) const { return {(*this)(v.x), (*this)(v.y), (*this)(v.z)}; }
  AffineMatrix operator()(AffineMatrix m) const {
    for (auto& row : m)
      for (double& entry : row) entry = (*this)(entry);
    return m;
  }

 private:
  bool is_float_;
};

}  // namespace plumb
