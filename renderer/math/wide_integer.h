#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace plumb {

/// A finite double as significand 2^exponent, the significand odd, or zero.
struct OddSignificand {
  explicit OddSignificand(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    const auto biased = static_cast<int>(bits >> 52 & 0x7ff);
    const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
    // Denormals have no hidden bit, and the exponent of the smallest normal numbers.
    const std::uint64_t whole = biased == 0 ? fraction : fraction | std::uint64_t{1} << 52;
    if (whole == 0) return;
    const int zeros = std::countr_zero(whole);
    significand = whole >> zeros;
    exponent = std::max(biased, 1) - 1075 + zeros;
    negative = bits >> 63;
  }

  std::uint64_t significand = 0;
  int exponent = 0;
  bool negative = false;
};

/// Between which powers of two the bits of some doubles lie: each is a multiple of 2^lowest, and less than 2^above.
struct BitSpan {
  int lowest = std::numeric_limits<int>::max(), above = std::numeric_limits<int>::min();
  void add(double value) {
    const OddSignificand odd(value);
    if (odd.significand == 0) return;
    lowest = std::min(lowest, odd.exponent);
    above = std::max(above, odd.exponent + static_cast<int>(std::bit_width(odd.significand)));
  }
  bool empty() const { return above < lowest; }
};

/// A whole number of N digits of 64 bits in two's complement. The caller knows that nothing overflows.
template <std::size_t N>
struct WideInteger {
  std::array<std::uint64_t, N> digits{};

  WideInteger() = default;
  /// value / 2^unit, which must be whole and fit.
  WideInteger(double value, int unit) {
    const OddSignificand odd(value);
    if (odd.significand == 0) return;
    const auto shift = static_cast<std::size_t>(odd.exponent - unit);
    const std::size_t digit = shift / 64, bits = shift % 64;
    digits[digit] = odd.significand << bits;
    if (bits > 0 && digit + 1 < N) digits[digit + 1] = odd.significand >> (64 - bits);
    if (odd.negative) *this = WideInteger() - *this;
  }

  bool negative() const { return digits[N - 1] >> 63; }
  int sign() const {
    std::uint64_t any = 0;
    for (const std::uint64_t digit : digits) any |= digit;
    return any == 0 ? 0 : negative() ? -1 : 1;
  }

  friend WideInteger operator+(const WideInteger& a, const WideInteger& b) {
    WideInteger sum;
    std::uint64_t carried = 0;
    for (std::size_t i = 0; i < N; ++i) {
      const Two digit = static_cast<Two>(a.digits[i]) + b.digits[i] + carried;
      sum.digits[i] = static_cast<std::uint64_t>(digit);
      carried = static_cast<std::uint64_t>(digit >> 64);
    }
    return sum;
  }

  friend WideInteger operator-(const WideInteger& a, const WideInteger& b) {
    WideInteger difference;
    std::uint64_t borrowed = 0;
    for (std::size_t i = 0; i < N; ++i) {
      const Two digit = static_cast<Two>(a.digits[i]) - b.digits[i] - borrowed;
      difference.digits[i] = static_cast<std::uint64_t>(digit);
      borrowed = static_cast<std::uint64_t>(digit >> 64) & 1;
    }
    return difference;
  }

  template <std::size_t M>
  friend WideInteger<N + M> operator*(const WideInteger& a, const WideInteger<M>& b) {
    WideInteger<N + M> product;
    for (std::size_t i = 0; i < N; ++i) {
      std::uint64_t carried = 0;
      for (std::size_t k = 0; k < M; ++k) {
        const Two digit = static_cast<Two>(a.digits[i]) * b.digits[k] + product.digits[i + k] + carried;
        product.digits[i + k] = static_cast<std::uint64_t>(digit);
        carried = static_cast<std::uint64_t>(digit >> 64);
      }
      product.digits[i + M] = carried;
    }
    // A negative number stands for itself plus 2^(64 digits): take the other off above it.
    if (a.negative()) product.take_off(b, N);
    if (b.negative()) product.take_off(a, M);
    return product;
  }

  /// Less other 2^(64 from), cut to the digits that there are.
  template <std::size_t M>
  void take_off(const WideInteger<M>& other, std::size_t from) {
    std::uint64_t borrowed = 0;
    for (std::size_t i = from; i < N; ++i) {
      const Two digit = static_cast<Two>(digits[i]) - other.digits[i - from] - borrowed;
      digits[i] = static_cast<std::uint64_t>(digit);
      borrowed = static_cast<std::uint64_t>(digit >> 64) & 1;
    }
  }

 private:
  __extension__ using Two = unsigned __int128;
};

}  // namespace plumb
