#include "meshes/validation/product_sum.h"

#include <bit>
#include <cmath>

namespace plumb {
namespace {

constexpr std::uint64_t kLow32 = 0xffffffff;

/// |x| = significand * 2^(shift - 1074), significand < 2^53, shift >= 0.
struct Whole {
  std::uint64_t significand;
  unsigned shift;
};

Whole whole(double x) {
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(std::fabs(x));
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
  const auto exponent = static_cast<unsigned>(bits >> 52);
  if (exponent == 0) return {fraction, 0};  // subnormal
  return {fraction | std::uint64_t{1} << 52, exponent - 1};
}

/// A number of six digits of 32 bits, the lowest first.
using Product = std::array<std::uint64_t, 6>;

/// The factor is below 2^53, so that neither half makes a sum overflow.
Product times(const Product& digits, std::uint64_t factor) {
  Product result{};
  for (std::size_t half = 0; half < 2; ++half) {
    const std::uint64_t digit = half == 0 ? factor & kLow32 : factor >> 32;
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i + half < result.size(); ++i) {
      const std::uint64_t sum = result[i + half] + digits[i] * digit + carry;
      result[i + half] = sum & kLow32;
      carry = sum >> 32;
    }
  }
  return result;
}

}  // namespace

void ProductSum::add(double a, double b, double c) {
  if (a == 0 || b == 0 || c == 0) return;
  const Whole x = whole(a), y = whole(b), z = whole(c);
  const unsigned shift = x.shift + y.shift + z.shift, within = shift % 32;
  // 53 + 31 bits, then 106 more: 190 of 192.
  Product product{(x.significand << within) & kLow32, (x.significand >> (32 - within)) & kLow32,
                  within == 0 ? 0 : x.significand >> (64 - within)};
  product = times(times(product, y.significand), z.significand);
  const bool negative = std::signbit(a) != (std::signbit(b) != std::signbit(c));
  for (std::size_t i = 0; i < product.size(); ++i) {
    const auto digit = static_cast<std::int64_t>(product[i]);
    digits_[shift / 32 + i] += negative ? -digit : digit;
  }
  if (++pending_ == 1u << 30) carry();
}

void ProductSum::carry() {
  std::int64_t carried = 0;
  for (std::size_t i = 0; i + 1 < kDigits; ++i) {
    const std::int64_t sum = digits_[i] + carried;
    carried = sum >> 32;
    digits_[i] = sum - carried * (std::int64_t{1} << 32);
  }
  digits_.back() += carried;
  pending_ = 0;
}

int ProductSum::sign() const {
  ProductSum carried = *this;
  carried.carry();
  // All digits but the highest are from 0 to 2^32 - 1 now.
  if (carried.digits_.back() < 0) return -1;
  for (const std::int64_t digit : carried.digits_)
    if (digit != 0) return 1;
  return 0;
}

}  // namespace plumb
