#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace plumb {

/// A fast way to read the numbers that mesh files are full of. What is not plain (exponents, very long or misspelt
/// words, the last words of a text) is refused, for a slower reader to take or to say what is wrong.

/// So many bytes must be readable from a number's first: a sign, 8 digits, a point, and three times the 8 bytes that
/// are looked at in one piece, and the byte behind them.
inline constexpr std::ptrdiff_t kPlainNumberReach = 1 + 8 + 1 + 3 * 8 + 1;

/// White space: space, tab, CR, LF, VT, FF.
constexpr bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// Up to eight digits at the begin of some bytes.
struct DigitRun {
  unsigned length;
  std::uint32_t value;
};

/// The run of digits at `at`, whose next 8 bytes must be readable. All eight bytes are treated as one number: the byte
/// of the first digit is the lowest one.
inline DigitRun digit_run(const char* at) {
  static_assert(std::endian::native == std::endian::little);
  std::uint64_t bytes;
  std::memcpy(&bytes, at, sizeof bytes);
  bytes ^= 0x3030303030303030;  // digits become 0 to 9, all else 10 to 255
  // The top bit of a byte is set where it is above 9: by itself or by adding 118. No sum of 7-bit numbers carries over.
  const std::uint64_t others = (((bytes & 0x7f7f7f7f7f7f7f7f) + 0x7676767676767676) | bytes) & 0x8080808080808080;
  if (others & 0x80) return {0, 0};
  const unsigned length = static_cast<unsigned>(std::countr_zero(others)) / 8;  // 8 where there are no others
  // Zeros in front, so that the last digit is in the top byte; then pairs, fours and eights of digits.
  bytes <<= 64 - 8 * length;
  bytes = (bytes * 10 + (bytes >> 8)) & 0x00ff00ff00ff00ff;
  bytes = (bytes * 100 + (bytes >> 16)) & 0x0000ffff0000ffff;
  bytes = bytes * 10000 + (bytes >> 32);
  return {length, static_cast<std::uint32_t>(bytes)};
}

/// digits / 10^places to the nearest double, the even one of two, for places up to 19; false in the few cases that the
/// arithmetic here does not settle. `digits` may be any number.
bool divide_by_power_of_ten(std::uint64_t digits, unsigned places, double& value);

namespace plain_number {

/// The powers of ten that a double holds exactly, as far as they are needed.
inline constexpr std::array<double, 20> kPowers = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,
                                                   1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19};
inline constexpr std::array<std::uint32_t, 9> kWholePowers = {1,      10,      100,      1000,     10000,
                                                              100000, 1000000, 10000000, 100000000};

}  // namespace plain_number

/// Takes a number of up to 8 digits before the point, if there is one, and up to 19 in all, with or without a sign, and
/// white space behind it. Returns the byte behind the number, whose nearest double is then in `value`; null if there
/// is none at `at` or it is not plain. kPlainNumberReach bytes must be readable from `at`.
inline const char* take_plain_decimal(const char* at, double& value) {
  const bool is_negative = *at == '-';
  if (is_negative || *at == '+') ++at;
  const DigitRun whole = digit_run(at);
  at += whole.length;
  std::uint64_t digits = whole.value;
  unsigned places = 0;
  if (*at == '.') {
    ++at;
    DigitRun run = digit_run(at);
    for (; run.length == 8 && places < 16; run = digit_run(at)) {
      digits = digits * 100000000 + run.value;
      places += 8;
      at += 8;
    }
    if (run.length == 8) return nullptr;
    digits = digits * plain_number::kWholePowers[run.length] + run.value;
    places += run.length;
    at += run.length;
  }
  // 19 digits are below 2^64, so nothing has overflown.
  if (!is_space(*at) || whole.length + places - 1U > 18U) return nullptr;
  if (digits <= std::uint64_t{1} << 53) {
    // Both are exact as doubles, and so the quotient is rounded once [Clinger 1990].
    value = static_cast<double>(static_cast<std::int64_t>(digits)) / plain_number::kPowers[places];
  } else if (!divide_by_power_of_ten(digits, places, value)) {
    return nullptr;
  }
  if (is_negative) value = -value;
  return at;
}

/// Takes a whole number of up to 8 digits without a sign, and white space behind it; otherwise as above.
inline const char* take_plain_whole(const char* at, std::uint32_t& value) {
  const DigitRun run = digit_run(at);
  if (run.length - 1U > 7U || !is_space(at[run.length])) return nullptr;
  value = run.value;
  return at + run.length;
}

}  // namespace plumb
