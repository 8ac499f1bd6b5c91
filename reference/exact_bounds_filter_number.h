#pragma once

#include <cmath>
#include <limits>
#include <optional>

namespace plumb {

/// An unevaluated sum hi + lo of two doubles (hi the sum rounded to nearest) and a bound on how far it is from the true
/// value: the number type of the filter. What is exact stays known as exact: its `error` is 0. Where the range of
/// doubles does not suffice, one of the three is infinite or NaN and round_up answers nothing.
///
/// How the bound is derived, u = 2^-53: sums, and the last steps of quotients and roots, measure what they lost by
/// exact sums and products [Knuth 1997, Dekker 1971] and put that into `error`; a product drops or rounds fewer than
/// eight terms of at most 8 u^2 of it, 64 u^2 = 2^-100. Whatever computes a bound is itself rounded a few times:
/// kSlack. Below 2^-900 the lower half of a product may underflow, by less than kTiny.
class FilterNumber {
 public:
  FilterNumber() = default;
  FilterNumber(double x) : hi_(x) {}

  /// Unknown: nothing can be decided from it.
  static FilterNumber undecided() { return {0, 0, std::numeric_limits<double>::infinity()}; }

  bool exact() const { return error_ == 0; }
  double approximation() const { return hi_; }
  /// The true value is within `error` of approximation + correction.
  double correction() const { return lo_; }
  double error() const { return error_; }
  /// The smallest double that is not below the true value, if the bound tells.
  std::optional<double> round_up() const;

  friend FilterNumber operator+(const FilterNumber& a, const FilterNumber& b);
  friend FilterNumber operator-(const FilterNumber& a) { return {-a.hi_, -a.lo_, a.error_}; }
  friend FilterNumber operator-(const FilterNumber& a, const FilterNumber& b) { return a + -b; }
  friend FilterNumber operator*(const FilterNumber& a, const FilterNumber& b);
  friend FilterNumber operator/(const FilterNumber& a, const FilterNumber& b);
  friend FilterNumber sqrt(const FilterNumber& a);
  friend FilterNumber abs(const FilterNumber& a) { return a.hi_ < 0 ? -a : a; }
  /// The bound covers the true maximum also where the bounds do not tell which it is.
  friend FilterNumber max(const FilterNumber& a, const FilterNumber& b);

 private:
  FilterNumber(double hi, double lo, double error) : hi_(hi), lo_(lo), error_(error) {}

  static constexpr double kSlack = 1 + 0x1p-40;
  static constexpr double kProduct = 0x1p-100;
  static constexpr double kTiny = 0x1p-1000;
  static constexpr double kSmall = 0x1p-900;

  /// Bounds on the magnitude of the true value.
  double most() const { return (std::fabs(hi_) + error_) * kSlack; }
  double least() const { return std::fabs(hi_) / kSlack - error_ * kSlack; }
  /// What remains over the divisor; more than zero also where that underflows.
  static double error_of_quotient(double rest, double divisor) {
    return rest == 0 ? 0 : rest / divisor * kSlack + kTiny;
  }

  double hi_ = 0, lo_ = 0, error_ = 0;
};

}  // namespace plumb
