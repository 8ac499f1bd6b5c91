#pragma once

#include <array>
#include <cstddef>

namespace plumb {

/// A number that is a sum of doubles, held without rounding: as doubles of rising magnitude whose bits do not overlap
/// [Shewchuk 1997]. Sums and products of such numbers are exact as long as no product of two parts leaves the range of
/// doubles: with inputs that are zero or within [2^-k, 2^k], a polynomial of degree n needs n (k + 53) <= 1000.
/// Infinity and NaN are not meant to come in.
class ExactSum {
 public:
  ExactSum() = default;
  /// This one double.
  ExactSum(double value) { add(value); }  // implicit, so that formulas read as formulas

  ExactSum& add(double value);
  ExactSum& add_product(double a, double b);

  ExactSum& operator+=(const ExactSum& other);
  ExactSum& operator-=(const ExactSum& other);
  friend ExactSum operator+(ExactSum a, const ExactSum& b) { return a += b; }
  friend ExactSum operator-(ExactSum a, const ExactSum& b) { return a -= b; }
  friend ExactSum operator*(const ExactSum& a, const ExactSum& b);

  /// -1, 0 or 1.
  int sign() const;
  /// The value in a 64-bit significand, off by less than 2^-62 of itself.
  long double rounded() const;
  /// Whether it is held as one double, or zero. Not every one that could be is.
  bool is_single() const { return count_ <= 1; }

 private:
  void compress();

  /// Parts that a compress() has made lie 2^53 apart at least, so all of a double's range holds 41 of them.
  static constexpr std::size_t kMost = 64;
  std::array<double, kMost> parts_{};
  std::size_t count_ = 0;
};

/// The smallest double that is not below the value, and the largest that is not above it.
double rounded_up(const ExactSum& value);
double rounded_down(const ExactSum& value);

/// The number center + |numerator / denominator| sqrt(radicand); denominator != 0, radicand >= 0.
struct SumWithRoot {
  ExactSum center, numerator, denominator, radicand;
};
/// The smallest double that is not below it, decided exactly.
double rounded_up(const SumWithRoot& value);

/// The smallest double not below a number of 64 bits.
double rounded_up(long double value);

}  // namespace plumb
