#pragma once

#include <cstdint>

namespace plumb {

/// Four floats that GCC and Clang keep in one register of any machine we build for; x, y, z and something else.
using BoxSide = float __attribute__((vector_size(16)));

inline BoxSide lower_of(BoxSide a, BoxSide b) { return a < b ? a : b; }
inline BoxSide higher_of(BoxSide a, BoxSide b) { return a > b ? a : b; }

/// What comparing two of them gives: all ones or zero.
using LaneMask = std::int32_t __attribute__((vector_size(16)));

/// The lanes with these numbers, 0 to 3.
[[gnu::always_inline]] inline BoxSide taken(BoxSide v, LaneMask lanes) {
#ifdef __clang__
  return BoxSide{v[lanes[0]], v[lanes[1]], v[lanes[2]], v[lanes[3]]};
#else
  return __builtin_shuffle(v, lanes);
#endif
}

/// The signs of the lanes, the first in the lowest bit.
[[gnu::always_inline]] inline std::uint32_t sign_bits(LaneMask lanes) {
#ifdef __SSE__
  return static_cast<std::uint32_t>(__builtin_ia32_movmskps(reinterpret_cast<BoxSide>(lanes)));
#else
  const auto bit = [&](int i) { return static_cast<std::uint32_t>(lanes[i]) >> 31 << i; };
  return bit(0) | bit(1) | bit(2) | bit(3);
#endif
}

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
