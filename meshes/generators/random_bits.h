#pragma once

#include <cstdint>

#include "renderer/math/vec3.h"

namespace plumb {

/// The finaliser of SplitMix64 [Steele 2014]: every bit of the result depends on every bit of `z`.
constexpr std::uint64_t mixed_bits(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

/// Random numbers of the generators: SplitMix64 [Steele 2014] and reals made of its bits by + and *, so the same on
/// every machine. Where an expression draws twice, draw into variables first: C++ leaves the order of operands open.
class RandomBits {
 public:
  /// The source of part `part` of a mesh (a district, a layer): near seeds and parts have nothing in common.
  RandomBits(std::uint64_t seed, std::uint64_t part) : state_(mixed_bits(mixed_bits(seed + kStep) + part * kStep)) {}

  std::uint64_t bits() { return mixed_bits(state_ += kStep); }
  bool coin() { return (bits() >> 63) != 0; }
  /// In [0, 1), a multiple of 2^-53.
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  /// (x, 0, z) in the disc of radius 1 but not in that of radius `inner` < 1, uniformly.
  Vec3 in_ring(double inner) {
    for (;;) {
      const double x = between(-1, 1);
      const double z = between(-1, 1);
      const double square = x * x + z * z;
      if (square <= 1 && square > inner * inner) return {x, 0, z};
    }
  }
  /// (x, 0, z) of unit length in any direction.
  Vec3 heading() { return normalized(in_ring(0.5)); }

 private:
  static constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15u;
  std::uint64_t state_;
};

}  // namespace plumb
