#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <optional>

#include "reference/exact_hit.h"
#include "reference/mpfr_number.h"

namespace plumb {

/// A closed interval with ends of MPFR that surely holds the true value: every operation rounds the lower end down and
/// the upper end up, to the larger precision of its operands. An end may be infinite, never NaN, if the operands of the
/// functions lie in their domains.
class MpfrInterval {
 public:
  /// Exactly zero.
  MpfrInterval() = default;
  /// Exactly `x`, which must be finite, if `bits` >= 53.
  MpfrInterval(double x, int bits);
  MpfrInterval(const mpq_class& x, int bits);
  static MpfrInterval pi(int bits);
  /// From any numbers with lower <= upper.
  MpfrInterval(MpfrNumber lower, MpfrNumber upper) : lower_(std::move(lower)), upper_(std::move(upper)) {}

  const MpfrNumber& lower() const { return lower_; }
  const MpfrNumber& upper() const { return upper_; }
  mpfr_prec_t bits() const { return std::max(lower_.bits(), upper_.bits()); }
  bool is_zero() const { return mpfr_zero_p(lower_.get()) && mpfr_zero_p(upper_.get()); }
  bool is_positive() const { return mpfr_sgn(lower_.get()) > 0; }

  friend MpfrInterval operator-(const MpfrInterval& a);
  friend MpfrInterval operator+(const MpfrInterval& a, const MpfrInterval& b);
  friend MpfrInterval operator-(const MpfrInterval& a, const MpfrInterval& b) { return a + -b; }
  friend MpfrInterval operator*(const MpfrInterval& a, const MpfrInterval& b);
  /// The whole line if `b` holds zero.
  friend MpfrInterval operator/(const MpfrInterval& a, const MpfrInterval& b);
  /// Of the part that is not negative.
  friend MpfrInterval sqrt(const MpfrInterval& a);
  /// Tighter than a * a: never negative.
  friend MpfrInterval square(const MpfrInterval& a);

 private:
  MpfrNumber lower_, upper_;
};

/// One of MPFR's functions of one argument.
using MpfrFunction = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
/// A function that does not decrease on the interval, or one that does not increase.
MpfrInterval increasing(MpfrFunction function, const MpfrInterval& a);
MpfrInterval decreasing(MpfrFunction function, const MpfrInterval& a);
/// The part below `most` (which must not be below the interval).
MpfrInterval at_most(const MpfrInterval& a, double most);

/// The enclosure of the true value in doubles, where the interval tells it.
std::optional<Enclosure> decided_enclosure(const MpfrInterval& a);
/// The doubles around the whole interval; wider than neighbours where it tells too little.
Enclosure widest_enclosure(const MpfrInterval& a);
/// The decided one; else, if the interval is tiny and holds one double, that double; else the widest.
Enclosure settled_enclosure(const MpfrInterval& a);
/// The nearest double, ties to even, where the interval tells it.
std::optional<double> decided_nearest(const MpfrInterval& a);

/// The enclosure and the nearest double of a fraction.
Enclosure enclose(const mpq_class& x);
double nearest(const mpq_class& x);

}  // namespace plumb
