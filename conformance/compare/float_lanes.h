#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace plumb {

/// Four floats that GCC and Clang keep in one register of any machine we build for, and the powers of FLIP on them: by
/// sums and products alone, so that every machine gives the same bits. Equal arguments give equal results.
using Lanes = float __attribute__((vector_size(16)));
using WholeLanes = std::int32_t __attribute__((vector_size(16)));
constexpr int kLanes = 4;

inline Lanes all_lanes(float value) { return Lanes{value, value, value, value}; }

inline Lanes load_lanes(const float* from) {
  Lanes lanes;
  std::memcpy(&lanes, from, sizeof lanes);
  return lanes;
}
inline void store_lanes(Lanes lanes, float* to) { std::memcpy(to, &lanes, sizeof lanes); }

inline Lanes lower_of(Lanes a, Lanes b) { return a < b ? a : b; }
inline Lanes higher_of(Lanes a, Lanes b) { return a > b ? a : b; }
inline Lanes magnitude_of(Lanes a) { return higher_of(a, -a); }
inline Lanes root_of(Lanes a) { return Lanes{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])}; }

/// The binary logarithm of positive normal floats. Its error is below 2e-7 + 2^-24 |log2 x|.
///
/// x = 2^e m with m from sqrt(1/2) to sqrt(2), and ln m = 2 artanh s with s = (m - 1) / (m + 1), |s| < 0.1716. The
/// first term that is left out is 2 s^11 / (11 ln 2) < 1e-9.
inline Lanes log2_of(Lanes x) {
  constexpr std::int32_t kRootOfHalf = 0x3f3504f3;
  const WholeLanes bits = std::bit_cast<WholeLanes>(x) - kRootOfHalf;
  const WholeLanes exponent = bits >> 23;
  const Lanes m = std::bit_cast<Lanes>((bits & 0x007fffff) + kRootOfHalf);
  const Lanes s = (m - 1.0F) / (m + 1.0F), ss = s * s;
  constexpr float kTwoOverLn2 = 2.8853900817779268F;
  const Lanes series = 1.0F + ss * (1.0F / 3 + ss * (1.0F / 5 + ss * (1.0F / 7 + ss * (1.0F / 9))));
  return __builtin_convertvector(exponent, Lanes) + kTwoOverLn2 * s * series;
}

/// 2^x for x from -126 to 127. Its relative error is below 3e-7.
///
/// x = n + f with a whole n and |f| <= 1/2; of the series of 2^f the first term that is left out is
/// (f ln 2)^8 / 8! < 6e-9.
inline Lanes exp2_of(Lanes x) {
  constexpr float kToWhole = 12582912;  // 1.5 * 2^23: added and taken away again, it rounds to a whole number
  const Lanes whole = (x + kToWhole) - kToWhole;
  const Lanes f = x - whole;
  constexpr float kTerms[] = {1.5252733804e-5F, 1.5403530393e-4F, 1.3333558146e-3F, 9.6181291076e-3F,
                              5.5504108665e-2F, 2.4022650696e-1F, 6.9314718056e-1F, 1.0F};
  Lanes power = all_lanes(0);
  for (const float term : kTerms) power = power * f + term;
  return power * std::bit_cast<Lanes>((__builtin_convertvector(whole, WholeLanes) + 127) << 23);
}

/// Cube roots of positive normal floats. Their relative error is below 3e-7.
///
/// Seen as a whole number, a float is nearly its logarithm; a third of that, with the offset of the exponent put right,
/// starts within 6 %. Each of Halley's steps, r (r^3 + 2x) / (2 r^3 + x), cubes the relative error e and multiplies it
/// by 2/3: 1.5e-4, then 3e-12.
inline Lanes cube_root_of(Lanes x) {
  constexpr float kTwoThirdsOfOne = 0x3f800000 * (2.0F / 3);
  const Lanes third = __builtin_convertvector(std::bit_cast<WholeLanes>(x), Lanes) * (1.0F / 3) + kTwoThirdsOfOne;
  Lanes root = std::bit_cast<Lanes>(__builtin_convertvector(third, WholeLanes));
  for (int step = 0; step < 2; ++step) {
    const Lanes cube = root * root * root;
    root = root * (cube + (x + x)) / (cube + cube + x);
  }
  return root;
}

/// base^exponent for bases from 0 and positive exponents; 0 up to 1e-30, and where the power is below 2^-126.
inline Lanes power_of(Lanes base, Lanes exponent) {
  constexpr float kTiny = 1e-30F, kLowest = -126;
  const Lanes logarithm = exponent * log2_of(base > kTiny ? base : all_lanes(1));
  const Lanes power = exp2_of(higher_of(logarithm, all_lanes(kLowest)));
  const Lanes zero = all_lanes(0);
  return base > kTiny ? (logarithm > kLowest ? power : zero) : zero;
}

}  // namespace plumb
