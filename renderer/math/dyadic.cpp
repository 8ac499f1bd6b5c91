#include "renderer/math/dyadic.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plumb {
namespace {

__extension__ using TwoDigits = unsigned __int128;
constexpr int kDigitBits = 64;

}  // namespace

Dyadic::Dyadic(double value) {
  if (value == 0) return;
  sign_ = value < 0 ? -1 : 1;
  int exponent = 0;
  const auto significand = static_cast<std::uint64_t>(std::ldexp(std::frexp(std::fabs(value), &exponent), 53));
  exponent -= 53;                                                                   // |value| = significand 2^exponent
  lowest_ = (exponent >= 0 ? exponent : exponent - (kDigitBits - 1)) / kDigitBits;  // rounded down
  const TwoDigits shifted = static_cast<TwoDigits>(significand) << (exponent - lowest_ * kDigitBits);
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
  std::size_t zeros = 0;
  while (digits_[zeros] == 0) ++zeros;
  if (zeros == 0) return;
  std::copy(digits_.begin() + static_cast<std::ptrdiff_t>(zeros), digits_.begin() + static_cast<std::ptrdiff_t>(count_),
            digits_.begin());
  count_ -= zeros;
  lowest_ += static_cast<int>(zeros);
}

std::uint64_t Dyadic::digit_at(int place) const {
  const int index = place - lowest_;
  return index >= 0 && index < static_cast<int>(count_) ? digits_[static_cast<std::size_t>(index)] : 0;
}

int Dyadic::compare_magnitudes(const Dyadic& a, const Dyadic& b) {
  const int top_a = a.lowest_ + static_cast<int>(a.count_), top_b = b.lowest_ + static_cast<int>(b.count_);
  if (top_a != top_b) return top_a < top_b ? -1 : 1;
  for (int place = top_a - 1; place >= std::min(a.lowest_, b.lowest_); --place) {
    const std::uint64_t digit_a = a.digit_at(place), digit_b = b.digit_at(place);
    if (digit_a != digit_b) return digit_a < digit_b ? -1 : 1;
  }
  return 0;
}

Dyadic Dyadic::sum(const Dyadic& a, const Dyadic& b, int sign_of_b) {
  if (sign_of_b == 0) return a;
  Dyadic result;
  if (a.sign_ == 0) {
    result = b;
    result.sign_ = sign_of_b;
    return result;
  }
  const bool adds = a.sign_ == sign_of_b;
  const int order = adds ? 1 : compare_magnitudes(a, b);
  if (order == 0) return result;
  const Dyadic& larger = order > 0 ? a : b;
  const Dyadic& smaller = order > 0 ? b : a;
  result.sign_ = order > 0 ? a.sign_ : sign_of_b;
  result.lowest_ = std::min(a.lowest_, b.lowest_);
  const int top = std::max(a.lowest_ + static_cast<int>(a.count_), b.lowest_ + static_cast<int>(b.count_));
  result.count_ = static_cast<std::size_t>(top - result.lowest_) + 1;
  if (result.count_ > kMost) throw std::logic_error("an exact number has more digits than its degree allows");
  std::uint64_t carried = 0;
  for (std::size_t i = 0; i < result.count_; ++i) {
    const int place = result.lowest_ + static_cast<int>(i);
    const TwoDigits first = larger.digit_at(place), second = smaller.digit_at(place);
    // Below zero the difference wraps around: its upper half is then all ones.
    const TwoDigits digit = adds ? first + second + carried : first - second - carried;
    result.digits_[i] = static_cast<std::uint64_t>(digit);
    carried = static_cast<std::uint64_t>(digit >> kDigitBits) & 1;
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
  long double value = 0;
  for (std::size_t i = count_ < 3 ? 0 : count_ - 3; i < count_; ++i)
    value += std::ldexp(static_cast<long double>(digits_[i]), kDigitBits * (lowest_ + static_cast<int>(i)));
  return static_cast<long double>(sign_) * value;
}

}  // namespace plumb
