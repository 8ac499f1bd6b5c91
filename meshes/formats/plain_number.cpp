#include "meshes/formats/plain_number.h"

namespace plumb {
namespace {

__extension__ using Wide = unsigned __int128;

/// 1 / 10^places is from `top` to less than `top + 1` times 2^-shift; `top` has 64 bits.
struct Reciprocal {
  std::uint64_t top;
  int shift;
};

constexpr std::array<Reciprocal, 20> kReciprocals = [] {
  std::array<Reciprocal, 20> table{};
  std::uint64_t power = 1;
  for (Reciprocal& r : table) {
    // 2^shift / power lies in (2^63, 2^64): the power has w bits and is above 2^(w - 1) unless it is 1.
    const int width = 64 - std::countl_zero(power);
    r.shift = 63 + width - (power == 1 ? 1 : 0);
    r.top = static_cast<std::uint64_t>((Wide{1} << r.shift) / power);
    power *= 10;  // overflows behind the last
  }
  return table;
}();

}  // namespace

/// A multiplication by the reciprocal with all 128 bits of the product, in the manner of [Lemire 2021]. With
/// m = digits 2^z, 2^63 <= m < 2^64, the quotient times 2^(z + shift) lies between P = m top and m (top + 1) < P +
/// 2^64. P is at least 2^126. So with H = floor(P / 2^64), 2^62 <= H < 2^64, the quotient times 2^(z + shift - 64) lies
/// in [H, H + 2). Of H's 64 or 63 bits, 53 are kept; below them are n = 11 or 10. If those spell at most half - 2 or
/// more than half, all of [H, H + 2) is rounded to the same: above half, H + 2 may reach past the next kept number, but
/// stays below the middle behind it. Otherwise, 2 times in 2^n, the answer is left to others; so are exact ties.
bool divide_by_power_of_ten(std::uint64_t digits, unsigned places, double& value) {
  if (digits == 0) {
    value = 0;
    return true;
  }
  const Reciprocal& reciprocal = kReciprocals[places];
  const int zeros = std::countl_zero(digits);
  const auto high = static_cast<std::uint64_t>(Wide{digits << zeros} * reciprocal.top >> 64);
  const int dropped = 11 - std::countl_zero(high);  // 2^62 <= high
  const std::uint64_t half = std::uint64_t{1} << (dropped - 1), rest = high & (2 * half - 1);
  if (rest + 1 >= half && rest <= half) return false;
  const std::uint64_t kept = (high >> dropped) + (rest > half ? 1 : 0);
  // Exact: `kept` is at most 2^53, and the power of two, from 2^-116 to 2^12, and the result are normal.
  const int exponent = 64 + dropped - zeros - reciprocal.shift;
  value = static_cast<double>(static_cast<std::int64_t>(kept)) *
          std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52);
  return true;
}

}  // namespace plumb
