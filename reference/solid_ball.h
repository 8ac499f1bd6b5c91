#pragma once

#include <cmath>
#include <limits>

namespace plumb {

/// An interval number of the solids' filter: |x - (hi + lo)| <= radius, with hi = round(hi + lo), so |lo| <= u |hi|,
/// u = 2^-53. Two doubles carry 106 bits, enough to round most t to neighbouring doubles; the rounding mode is left
/// alone. A NaN anywhere makes every decision undecided; an overflow becomes one, because the error term of a sum or
/// product that overflows is inf - inf.
///
/// Every operation keeps the enclosure: derivations stand at each. Sums of non-negative radii are rounded up by
/// `round_up`. An operation whose result is exact (all error terms zero) has radius zero, so ties between small whole
/// numbers are decided here.
struct Ball {
  double hi = 0;
  double lo = 0;
  double radius = 0;

  Ball() = default;
  /// Exactly `x`.
  Ball(double x) : hi(x) {}  // NOLINT: a number like others in a template
  Ball(double high, double low, double r) : hi(high), lo(low), radius(r) {}
};

/// At least the exact value of a sum of up to eight non-negative terms or of a quotient that was computed to nearest:
/// eight roundings make (1 + u)^8 < 1 + 2^-49, and the product rounds once more. Sums below 2^-1022 are exact.
inline double round_up(double x) { return x * (1 + 0x1p-48); }

/// Stands for all underflow in a product or quotient, each of which loses at most 2^-1074 a term.
constexpr double kUnderflow = 0x1p-1000;

struct TwoDoubles {
  double sum, error;
};

/// a + b = sum + error exactly, unless it overflows [Knuth 1997, section 4.2.2].
inline TwoDoubles two_sum(double a, double b) {
  const double sum = a + b;
  const double virtual_b = sum - a;
  return {sum, (a - (sum - virtual_b)) + (b - virtual_b)};
}

/// a b = sum + error exactly if 2^-960 <= |a b| and neither is above 2^995 [Dekker 1971]. Below, the partial products
/// can drop bits: a and b are whole multiples of powers whose product is at least 2^-106 |a b|, so above it they do
/// not.
inline TwoDoubles two_product(double a, double b) {
  constexpr double kSplit = 0x1p27 + 1;
  const double sa = kSplit * a;
  const double sb = kSplit * b;
  const double a_high = sa - (sa - a);
  const double b_high = sb - (sb - b);
  const double a_low = a - a_high;
  const double b_low = b - b_high;
  const double product = a * b;
  return {product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

/// At least |x|: |hi + lo| <= (1 + u) |hi|.
inline double magnitude(const Ball& x) { return round_up(std::fabs(x.hi) + x.radius); }

inline Ball operator-(const Ball& a) { return {-a.hi, -a.lo, a.radius}; }

/// The four parts are added without error but for the two smallest terms, which go to the radius.
inline Ball operator+(const Ball& a, const Ball& b) {
  const auto [s, e] = two_sum(a.hi, b.hi);
  const auto [t, f] = two_sum(a.lo, b.lo);
  const auto [u, v] = two_sum(e, t);
  const auto [h, l] = two_sum(s, u);
  const auto [w, x] = two_sum(l, v);
  const auto [hi, lo] = two_sum(h, w);
  return {hi, lo, round_up(a.radius + b.radius + std::fabs(x) + std::fabs(f))};
}

inline Ball operator-(const Ball& a, const Ball& b) { return a + -b; }

/// Dropped: a.lo b.lo <= u^2 |p|, and four roundings of at most u (u |p|), 2 u (u |p|) and 3 u (u |p|), so less than
/// 16 u^2 |p| = 2^-102 |p| in all. The radii add |a| rb + |b| ra + ra rb.
inline Ball operator*(const Ball& a, const Ball& b) {
  const auto [p, e] = two_product(a.hi, b.hi);
  double low = e;
  double error = 0;
  if (a.lo != 0 || b.lo != 0) {
    low += a.hi * b.lo + a.lo * b.hi;
    error = 0x1p-102 * std::fabs(p);
  }
  if (a.radius != 0 || b.radius != 0) {
    error +=
        round_up(std::fabs(a.hi)) * b.radius + round_up(std::fabs(b.hi)) * a.radius + a.radius * b.radius + kUnderflow;
  }
  if (!(std::fabs(p) >= 0x1p-960) && a.hi != 0 && b.hi != 0) error += kUnderflow;
  const auto [hi, lo] = two_sum(p, low);
  return {hi, lo, round_up(error)};
}

/// What a quotient or root q of an exact residual r is off by: |r| / |divisor|, where the divisor is at least
/// `smallest`; NaN if that is not positive.
inline Ball with_residual(double first, double second, const Ball& residual, double smallest) {
  const auto [hi, lo] = two_sum(first, second);
  const double error = magnitude(residual);
  if (!(smallest > 0)) return {hi, lo, std::numeric_limits<double>::quiet_NaN()};
  return {hi, lo, error == 0 ? 0 : round_up(error / smallest) + kUnderflow};
}

/// a / b - q = (a - q b) / b, for any q; the residual is taken with all radii.
inline Ball operator/(const Ball& a, const Ball& b) {
  const double first = a.hi / b.hi;
  const double second = (a - b * Ball(first)).hi / b.hi;
  const auto [hi, lo] = two_sum(first, second);
  const Ball residual = a - b * Ball(hi, lo, 0);
  return with_residual(hi, lo, residual, std::fabs(b.hi) * (1 - 0x1p-50) - round_up(b.radius));
}

/// Of a number known to be >= 0: |sqrt(a) - q| = |a - q^2| / (sqrt(a) + q) <= |a - q^2| / q, for any q > 0.
inline Ball sqrt(const Ball& a) {
  if (a.hi == 0 && a.radius == 0) return {};
  const double first = std::sqrt(a.hi);
  const Ball square = Ball(first) * Ball(first);
  const double second = (a - square).hi / (2 * first);
  const auto [hi, lo] = two_sum(first, second);
  const Ball root{hi, lo, 0};
  return with_residual(hi, lo, a - root * root, hi * (1 - 0x1p-50));
}

constexpr int kUndecided = 2;

/// -1, 0 or 1 if it is certain, else kUndecided. |hi + lo| >= (1 - u) |hi|.
inline int sign_or_undecided(const Ball& x) {
  if (x.radius == 0) return x.hi > 0 ? 1 : x.hi < 0 ? -1 : x.hi == 0 ? 0 : kUndecided;
  const double margin = round_up(x.radius);
  if (x.hi > margin) return 1;
  if (x.hi < -margin) return -1;
  return kUndecided;
}

}  // namespace plumb
