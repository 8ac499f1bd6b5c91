#include "renderer/math/dyadic.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

namespace plumb {
namespace {

__extension__ using TwoDigits = unsigned __int128;
constexpr int kDigitBits = 64;

}  // namespace

Dyadic::Dyadic(double value) {
  if (value == 0) return;
  const auto bits = std::bit_cast<std::uint64_t>(value);
  sign_ = bits >> 63 ? -1 : 1;
  const auto biased = static_cast<int>(bits >> 52 & 0x7ff);
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
  // |value| = significand 2^exponent; denormals have no hidden bit, and the exponent of the smallest normal numbers.
  const std::uint64_t significand = biased == 0 ? fraction : fraction | std::uint64_t{1} << 52;
  const int exponent = std::max(biased, 1) - 1075;
  lowest_ = exponent >> 6;  // rounded down
  const TwoDigits shifted = static_cast<TwoDigits>(significand) << (exponent & 63);
  digits_[0] = static_cast<std::uint64_t>(shifted);
  digits_[1] = static_cast<std::uint64_t>(shifted >> kDigitBits);
  count_ = 2;
  trim();
}

Dyadic& Dyadic::operator=(const Dyadic& other) {
  sign_ = other.sign_;
  lowest_ = other.lowest_;
  count_ = other.count_;
  std::copy_n(other.digits_.begin(), count_, digits_.begin());
  return *this;
}

void Dyadic::trim() {
  while (count_ > 0 && digits_[count_ - 1] == 0) --count_;
  if (count_ == 0) {
    sign_ = 0;
    return;
  }
  if (digits_[0] != 0) return;
  std::size_t zeros = 1;
  while (digits_[zeros] == 0) ++zeros;
  count_ -= zeros;
  lowest_ += static_cast<int>(zeros);
  for (std::size_t i = 0; i < count_; ++i) digits_[i] = digits_[i + zeros];
}

Dyadic Dyadic::sum(const Dyadic& a, const Dyadic& b, int sign_of_b) {
  if (sign_of_b == 0) return a;
  Dyadic result;
  if (a.sign_ == 0) {
    result = b;
    result.sign_ = sign_of_b;
    return result;
  }
  const Dyadic& low = a.lowest_ <= b.lowest_ ? a : b;
  const Dyadic& high = a.lowest_ <= b.lowest_ ? b : a;
  const auto gap = static_cast<std::size_t>(high.lowest_ - low.lowest_);
  const std::size_t count = std::max(low.count_, gap + high.count_) + 1;
  if (count > kMost) throw std::logic_error("an exact number has more digits than its degree allows");
  result.lowest_ = low.lowest_;
  result.count_ = count;
  auto& digits = result.digits_;
  std::copy_n(low.digits_.begin(), low.count_, digits.begin());
  std::fill(digits.begin() + static_cast<std::ptrdiff_t>(low.count_),
            digits.begin() + static_cast<std::ptrdiff_t>(count), 0);
  std::uint64_t carried = 0;
  if (a.sign_ == sign_of_b) {
    result.sign_ = a.sign_;
    for (std::size_t i = gap; i < count && (i < gap + high.count_ || carried); ++i) {
      const TwoDigits digit =
          static_cast<TwoDigits>(digits[i]) + (i < gap + high.count_ ? high.digits_[i - gap] : 0) + carried;
      digits[i] = static_cast<std::uint64_t>(digit);
      carried = static_cast<std::uint64_t>(digit >> kDigitBits);
    }
  } else {
    // low - high; where that is negative, it has borrowed from above the highest digit, and is turned round.
    result.sign_ = &low == &a ? a.sign_ : sign_of_b;
    for (std::size_t i = gap; i < count && (i < gap + high.count_ || carried); ++i) {
      const TwoDigits digit =
          static_cast<TwoDigits>(digits[i]) - (i < gap + high.count_ ? high.digits_[i - gap] : 0) - carried;
      digits[i] = static_cast<std::uint64_t>(digit);
      carried = static_cast<std::uint64_t>(digit >> kDigitBits) & 1;
    }
    if (carried) {
      result.sign_ = -result.sign_;
      std::uint64_t one = 1;
      for (std::size_t i = 0; i < count; ++i) {
        digits[i] = ~digits[i] + one;
        if (digits[i] != 0) one = 0;
      }
    }
  }
  result.trim();
  return result;
}

Dyadic operator*(const Dyadic& a, const Dyadic& b) {
  Dyadic product;
  if (a.sign_ == 0 || b.sign_ == 0) return product;
  product.sign_ = a.sign_ * b.sign_;
  product.lowest_ = a.lowest_ + b.lowest_;
  product.count_ = a.count_ + b.count_;
  if (product.count_ > Dyadic::kMost) throw std::logic_error("an exact number has more digits than its degree allows");
  std::fill_n(product.digits_.begin(), product.count_, 0);
  for (std::size_t i = 0; i < a.count_; ++i) {
    std::uint64_t carried = 0;
    for (std::size_t k = 0; k < b.count_; ++k) {
      const TwoDigits digit = static_cast<TwoDigits>(a.digits_[i]) * b.digits_[k] + product.digits_[i + k] + carried;
      product.digits_[i + k] = static_cast<std::uint64_t>(digit);
      carried = static_cast<std::uint64_t>(digit >> kDigitBits);
    }
    product.digits_[i + b.count_] = carried;
  }
  product.trim();
  return product;
}

long double Dyadic::rounded() const {
  // The highest digit may have a single bit. With the two below it, what is left out is less than 2^-128 of the value,
  // and each of the two sums rounds by 2^-64 of it.
  if (count_ == 0) return 0;
  const auto digit = [this](std::size_t from_top) {
    return from_top < count_ ? static_cast<long double>(digits_[count_ - 1 - from_top]) : 0.0L;
  };
  const long double value = digit(0) + (0x1p-64L * digit(1) + 0x1p-128L * digit(2));
  return std::ldexp(static_cast<long double>(sign_) * value, kDigitBits * (lowest_ + static_cast<int>(count_) - 1));
}

}  // namespace plumb
