#pragma once

namespace plumb::bench {

/// The nearest float. GCC 12 drops the rounding where it vectorises a conversion there and back; volatile keeps it.
inline double as_float(double x) {
  volatile float rounded = static_cast<float>(x);
  return static_cast<double>(rounded);
}

/// Each number rounded to the nearest float.
template <class Triple>
Triple as_floats(const Triple& v) {
  return {as_float(v.x), as_float(v.y), as_float(v.z)};
}

}  // namespace plumb::bench
