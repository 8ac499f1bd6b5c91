#pragma once

#include <cmath>
#include <cstdint>
#include <string_view>

namespace plumb {

/// Random numbers that are the same on every machine: SplitMix64 [Steele 2014], and reals made of its bits by + and *
/// alone. Where an expression draws twice, draw into variables first: C++ leaves the order of operands open.
class Random {
 public:
  /// The source of the `index`-th case of a stream (a family, by its id): near seeds and indices have nothing in
  /// common.
  Random(std::uint64_t seed, std::string_view stream, std::uint64_t index) {
    std::uint64_t name = 0xcbf29ce484222325u;
    for (const char c : stream) name = (name ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    state_ = mixed(mixed(mixed(seed + kStep) ^ name) + index * kStep);
  }

  std::uint64_t bits() { return mixed(state_ += kStep); }
  /// Less than `count`, which is not 0 and fits 32 bits.
  std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>(((bits() >> 32) * count) >> 32); }
  /// From `low` to `high`, both included.
  int integer(int low, int high) { return low + static_cast<int>(below(static_cast<std::uint32_t>(high - low + 1))); }
  /// A whole number from -reach to reach, which may need more than 32 bits (reach < 2^52).
  double whole(double reach) { return std::floor(between(-reach, reach + 1)); }
  bool one_in(std::uint32_t count) { return below(count) == 0; }
  bool coin() { return one_in(2); }
  double sign() { return coin() ? 1.0 : -1.0; }
  /// In [0, 1), a multiple of 2^-53.
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  /// Between low and high (0 < low <= high), each power of two as likely as the next.
  double magnitude(double low, double high);

 private:
  static constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15u;
  static std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  std::uint64_t state_;
};

}  // namespace plumb
