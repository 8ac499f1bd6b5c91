#pragma once

#include <cstdint>

namespace plumb {

/// Four floats that GCC and Clang keep in one register of any machine we build for; x, y, z and something else.
using BoxSide = float __attribute__((vector_size(16)));

inline BoxSide lower_of(BoxSide a, BoxSide b) { return a < b ? a : b; }
inline BoxSide higher_of(BoxSide a, BoxSide b) { return a > b ? a : b; }

/// A box in floats.
struct FloatBox {
  static constexpr float kFar = 3e38F;
  BoxSide low{kFar, kFar, kFar, kFar};
  BoxSide high{-kFar, -kFar, -kFar, -kFar};

  void extend(const FloatBox& other) {
    low = lower_of(low, other.low);
    high = higher_of(high, other.high);
  }
  void extend(BoxSide point) {
    low = lower_of(low, point);
    high = higher_of(high, point);
  }
  /// Half the area of the surface; of an empty box something useless.
  float half_area() const {
    const BoxSide e = high - low;
    return e[0] * e[1] + e[1] * e[2] + e[2] * e[0];
  }
};

}  // namespace plumb
