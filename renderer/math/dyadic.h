#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "renderer/math/wide_integer.h"

namespace plumb {

/// A whole number times a power of two, held without rounding. Any polynomial of degree up to 11 in any finite doubles
/// can be formed: there is no range to keep, as there is for ExactSum, and products are faster. Infinity and NaN must
/// not come in.
class Dyadic {
 public:
  /// Zero.
  Dyadic() = default;
  /// This one double.
  Dyadic(double value);  // implicit, so that formulas read as formulas
  /// integer 2^exponent; a double must hold that power.
  template <std::size_t N>
  Dyadic(const WideInteger<N>& integer, int exponent) {
    WideInteger<N> size = integer;
    sign_ = 1;
    if (integer.negative()) {
      sign_ = -1;
      size = WideInteger<N>() - integer;
    }
    count_ = N;
    std::copy_n(size.digits.begin(), N, digits_.begin());
    trim();
    if (exponent != 0) *this = *this * std::ldexp(1.0, exponent);
  }
  Dyadic(const Dyadic& other) { *this = other; }
  Dyadic& operator=(const Dyadic& other);

  friend Dyadic operator+(const Dyadic& a, const Dyadic& b) { return sum(a, b, b.sign_); }
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return sum(a, b, -b.sign_); }
  friend Dyadic operator*(const Dyadic& a, const Dyadic& b);

  /// -1, 0 or 1.
  int sign() const { return sign_; }
  /// The value in a 64-bit significand, off by less than 2^-62 of itself.
  long double rounded() const;

 private:
  /// a + b with this sign for b.
  static Dyadic sum(const Dyadic& a, const Dyadic& b, int sign_of_b);
  /// Drops zeros at both ends.
  void trim();

  /// A double lies in 33 places of 64 bits, from -17 (2^-1074) to 15; 11 of them multiplied in 363. Sums of such
  /// products are a few bits longer.
  static constexpr std::size_t kMost = 368;

  int sign_ = 0;
  /// |value| = sum of digits_[i] 2^(64 (lowest_ + i)), i < count_.
  int lowest_ = 0;
  std::size_t count_ = 0;
  std::array<std::uint64_t, kMost> digits_;  // only those below count_ are ever read
};

}  // namespace plumb
