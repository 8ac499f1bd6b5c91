#pragma once

#include <gmpxx.h>

#include "reference/exact_hit.h"

namespace plumb {

/// An exact fraction, not necessarily in lowest terms. For the oracle's own sources only.
struct Quotient {
  mpz_class numerator = 0;
  /// Above zero.
  mpz_class denominator = 1;
};

/// numerator / denominator; the denominator is not zero.
Quotient make_quotient(const mpq_class& numerator, const mpq_class& denominator);
Quotient make_quotient(const mpq_class& value);

/// -1, 0 or 1 as a < b, a = b or a > b.
int compare(const Quotient& a, const Quotient& b);

/// The neighbouring doubles around a fraction, and it rounded to nearest, ties to even. Follows IEEE 754 in denormals
/// and overflow.
struct RoundedQuotient {
  Enclosure enclosure;
  double to_double = 0;
  float to_float = 0;
};
RoundedQuotient round_quotient(const Quotient& value);

/// The exact value of the unit vector along a vector that is not zero, each coordinate within 2^-53.
Normal3 round_direction(const std::array<mpz_class, 3>& vector);

}  // namespace plumb
