#include "reference/quotient.h"

#include <mpfr.h>

#include <cmath>
#include <cstring>

namespace plumb {
namespace {

long bits(const mpz_class& x) { return static_cast<long>(mpz_sizeinbase(x.get_mpz_t(), 2)); }

/// Of two neighbours the one whose last bit is 1, which stands for all values strictly between them: a second rounding
/// to a format that has at least two bits less is then right [Boldo 2008].
double odd_neighbour(const Enclosure& enclosure) {
  std::uint64_t last;
  std::memcpy(&last, &enclosure.below, sizeof last);
  return last & 1 ? enclosure.below : enclosure.above;
}

}  // namespace

Quotient make_quotient(const mpq_class& numerator, const mpq_class& denominator) {
  Quotient result{numerator.get_num() * denominator.get_den(), numerator.get_den() * denominator.get_num()};
  if (result.denominator < 0) {
    result.numerator = -result.numerator;
    result.denominator = -result.denominator;
  }
  return result;
}

Quotient make_quotient(const mpq_class& value) { return {value.get_num(), value.get_den()}; }

int compare(const Quotient& a, const Quotient& b) {
  const int order = cmp(a.numerator * b.denominator, b.numerator * a.denominator);
  return (order > 0) - (order < 0);
}

RoundedQuotient round_quotient(const Quotient& value) {
  constexpr long kDigits = 53, kLowestBit = -1074;
  if (value.numerator == 0) return {};
  const mpz_class size = abs(value.numerator);
  // 2^exponent <= size / denominator after the correction. The quotient is cut at the last bit of its binade.
  long exponent = bits(size) - bits(value.denominator);
  if (exponent >= 0 ? size < mpz_class(value.denominator << static_cast<unsigned long>(exponent))
                    : mpz_class(size << static_cast<unsigned long>(-exponent)) < value.denominator)
    --exponent;
  const long last_bit = std::max(exponent - (kDigits - 1), kLowestBit);
  mpz_class dividend = size, divisor = value.denominator, quotient, rest;
  if (last_bit > 0)
    divisor <<= static_cast<unsigned long>(last_bit);
  else
    dividend <<= static_cast<unsigned long>(-last_bit);
  mpz_tdiv_qr(quotient.get_mpz_t(), rest.get_mpz_t(), dividend.get_mpz_t(), divisor.get_mpz_t());

  const unsigned long mantissa = quotient.get_ui();  // below 2^53
  const auto scaled = [&](unsigned long m) {         // exact, or infinite
    return std::ldexp(static_cast<double>(m), static_cast<int>(std::min(last_bit, 2000L)));
  };
  double below = scaled(mantissa);
  double above = rest == 0 ? below : scaled(mantissa + 1);
  const int half = cmp(mpz_class(2 * rest), divisor);
  double nearest = half > 0 || (half == 0 && mantissa % 2 == 1) ? above : below;
  if (std::isinf(below)) {
    below = std::numeric_limits<double>::max();
    above = nearest = std::numeric_limits<double>::infinity();
  }
  const bool negative = value.numerator < 0;
  RoundedQuotient result;
  result.enclosure = negative ? Enclosure{-above, -below} : Enclosure{below, above};
  result.to_double = negative ? -nearest : nearest;
  result.to_float = static_cast<float>(below == above ? result.to_double : odd_neighbour(result.enclosure));
  return result;
}

Normal3 round_direction(const std::array<mpz_class, 3>& vector) {
  // 128 bits: five roundings are off by less than 2^-125, the last one to double by at most 2^-54.
  constexpr mpfr_prec_t kPrecision = 128;
  mpfr_t part[3], square, sum;
  for (mpfr_t& p : part) mpfr_init2(p, kPrecision);
  mpfr_inits2(kPrecision, square, sum, static_cast<mpfr_ptr>(nullptr));
  mpfr_set_zero(sum, 1);
  for (std::size_t i = 0; i < 3; ++i) {
    mpfr_set_z(part[i], vector[i].get_mpz_t(), MPFR_RNDN);
    mpfr_sqr(square, part[i], MPFR_RNDN);
    mpfr_add(sum, sum, square, MPFR_RNDN);
  }
  mpfr_sqrt(sum, sum, MPFR_RNDN);
  Normal3 result;
  for (int i = 0; i < 3; ++i) {
    mpfr_div(part[i], part[i], sum, MPFR_RNDN);
    result[i] = mpfr_get_d(part[i], MPFR_RNDN);
  }
  for (mpfr_t& p : part) mpfr_clear(p);
  mpfr_clears(square, sum, static_cast<mpfr_ptr>(nullptr));
  return result;
}

}  // namespace plumb
