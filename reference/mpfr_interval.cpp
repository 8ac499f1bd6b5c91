#include "reference/mpfr_interval.h"

#include <cmath>

namespace plumb {
namespace {

/// Both zeros compare equal, but an enclosure should not show a -0.
double to_double(const MpfrNumber& x, mpfr_rnd_t rounding) { return mpfr_get_d(x.get(), rounding) + 0.0; }

/// Runs `compute(target, rounding)` twice, or once where the first result was exact.
template <class Compute>
MpfrInterval rounded_both_ways(mpfr_prec_t bits, const Compute& compute) {
  MpfrNumber lower(bits);
  const int direction = compute(lower.get(), MPFR_RNDD);
  MpfrNumber upper = lower;
  // The true value lies strictly between two neighbours.
  if (direction != 0) mpfr_nextabove(upper.get());
  return {std::move(lower), std::move(upper)};
}

}  // namespace

MpfrInterval::MpfrInterval(double x, int bits)
    : MpfrInterval(rounded_both_ways(
          bits, [&](mpfr_ptr target, mpfr_rnd_t rounding) { return mpfr_set_d(target, x, rounding); })) {}

MpfrInterval::MpfrInterval(const mpq_class& x, int bits)
    : MpfrInterval(rounded_both_ways(
          bits, [&](mpfr_ptr target, mpfr_rnd_t rounding) { return mpfr_set_q(target, x.get_mpq_t(), rounding); })) {}

MpfrInterval MpfrInterval::pi(int bits) {
  return rounded_both_ways(bits, [](mpfr_ptr target, mpfr_rnd_t rounding) { return mpfr_const_pi(target, rounding); });
}

MpfrInterval operator-(const MpfrInterval& a) {
  MpfrInterval result(a.upper_, a.lower_);
  mpfr_neg(result.lower_.get(), result.lower_.get(), MPFR_RNDN);
  mpfr_neg(result.upper_.get(), result.upper_.get(), MPFR_RNDN);
  return result;
}

MpfrInterval operator+(const MpfrInterval& a, const MpfrInterval& b) {
  const mpfr_prec_t bits = std::max(a.bits(), b.bits());
  MpfrNumber lower(bits), upper(bits);
  mpfr_add(lower.get(), a.lower_.get(), b.lower_.get(), MPFR_RNDD);
  mpfr_add(upper.get(), a.upper_.get(), b.upper_.get(), MPFR_RNDU);
  return {std::move(lower), std::move(upper)};
}

MpfrInterval operator*(const MpfrInterval& a, const MpfrInterval& b) {
  // Also where the other is infinite: no true value is.
  if (a.is_zero() || b.is_zero()) return {};
  const mpfr_prec_t bits = std::max(a.bits(), b.bits());
  MpfrNumber lower(bits), upper(bits), product(bits);
  mpfr_set_inf(lower.get(), 1);
  mpfr_set_inf(upper.get(), -1);
  for (const MpfrNumber* x : {&a.lower_, &a.upper_})
    for (const MpfrNumber* y : {&b.lower_, &b.upper_}) {
      mpfr_mul(product.get(), x->get(), y->get(), MPFR_RNDD);
      mpfr_min(lower.get(), lower.get(), product.get(), MPFR_RNDD);
      mpfr_mul(product.get(), x->get(), y->get(), MPFR_RNDU);
      mpfr_max(upper.get(), upper.get(), product.get(), MPFR_RNDU);
    }
  return {std::move(lower), std::move(upper)};
}

MpfrInterval operator/(const MpfrInterval& a, const MpfrInterval& b) {
  const mpfr_prec_t bits = std::max(a.bits(), b.bits());
  MpfrNumber lower(bits), upper(bits);
  if (mpfr_sgn(b.lower_.get()) <= 0 && mpfr_sgn(b.upper_.get()) >= 0) {
    mpfr_set_inf(lower.get(), -1);
    mpfr_set_inf(upper.get(), 1);
    return {std::move(lower), std::move(upper)};
  }
  mpfr_ui_div(lower.get(), 1, b.upper_.get(), MPFR_RNDD);
  mpfr_ui_div(upper.get(), 1, b.lower_.get(), MPFR_RNDU);
  return a * MpfrInterval(std::move(lower), std::move(upper));
}

MpfrInterval sqrt(const MpfrInterval& a) {
  MpfrNumber lower(a.bits()), upper(a.bits());
  if (mpfr_sgn(a.lower_.get()) > 0) mpfr_sqrt(lower.get(), a.lower_.get(), MPFR_RNDD);
  if (mpfr_sgn(a.upper_.get()) > 0) mpfr_sqrt(upper.get(), a.upper_.get(), MPFR_RNDU);
  return {std::move(lower), std::move(upper)};
}

MpfrInterval square(const MpfrInterval& a) {
  MpfrInterval result = a * a;
  if (mpfr_sgn(result.lower_.get()) < 0) mpfr_set_zero(result.lower_.get(), 1);
  return result;
}

MpfrInterval increasing(MpfrFunction function, const MpfrInterval& a) {
  MpfrNumber lower(a.bits()), upper(a.bits());
  function(lower.get(), a.lower().get(), MPFR_RNDD);
  function(upper.get(), a.upper().get(), MPFR_RNDU);
  return {std::move(lower), std::move(upper)};
}

MpfrInterval decreasing(MpfrFunction function, const MpfrInterval& a) {
  MpfrNumber lower(a.bits()), upper(a.bits());
  function(lower.get(), a.upper().get(), MPFR_RNDD);
  function(upper.get(), a.lower().get(), MPFR_RNDU);
  return {std::move(lower), std::move(upper)};
}

MpfrInterval at_most(const MpfrInterval& a, double most) {
  MpfrNumber upper = a.upper();
  if (mpfr_cmp_d(upper.get(), most) > 0) mpfr_set_d(upper.get(), most, MPFR_RNDU);
  return {a.lower(), std::move(upper)};
}

std::optional<Enclosure> decided_enclosure(const MpfrInterval& a) {
  const Enclosure widest = widest_enclosure(a);
  if (widest.below != to_double(a.upper(), MPFR_RNDD) || widest.above != to_double(a.lower(), MPFR_RNDU))
    return std::nullopt;
  return widest;
}

Enclosure widest_enclosure(const MpfrInterval& a) {
  return {to_double(a.lower(), MPFR_RNDD), to_double(a.upper(), MPFR_RNDU)};
}

Enclosure settled_enclosure(const MpfrInterval& a) {
  if (const auto decided = decided_enclosure(a)) return *decided;
  const double only = to_double(a.lower(), MPFR_RNDU);
  MpfrNumber width(64), allowed(64);
  mpfr_sub(width.get(), a.upper().get(), a.lower().get(), MPFR_RNDU);
  // Around zero the interval is tiny by holding no other double.
  mpfr_set_d(allowed.get(), only == 0 ? 1 : std::fabs(only), MPFR_RNDD);
  mpfr_mul_2si(allowed.get(), allowed.get(), -200, MPFR_RNDD);
  if (only == to_double(a.upper(), MPFR_RNDD) && mpfr_lessequal_p(width.get(), allowed.get())) return {only, only};
  return widest_enclosure(a);
}

std::optional<double> decided_nearest(const MpfrInterval& a) {
  const double result = to_double(a.lower(), MPFR_RNDN);
  if (result != to_double(a.upper(), MPFR_RNDN)) return std::nullopt;
  return result;
}

Enclosure enclose(const mpq_class& x) {
  // Rounding down twice, to 53 bits with a wide exponent and then to a double, rounds down; likewise up.
  return widest_enclosure(MpfrInterval(x, 53));
}

double nearest(const mpq_class& x) {
  // Two roundings to nearest may differ from one. Where the first 66 bits do not tell all, a bit far below them stands
  // for the rest: neither a double nor a point between two neighbours has as many.
  MpfrNumber value(66);
  if (mpfr_set_q(value.get(), x.get_mpq_t(), MPFR_RNDZ) != 0) {
    mpfr_prec_round(value.get(), 80, MPFR_RNDN);
    x > 0 ? mpfr_nextabove(value.get()) : mpfr_nextbelow(value.get());
  }
  return to_double(value, MPFR_RNDN);
}

}  // namespace plumb
