#include "renderer/math/rotation.h"

#include <mpfr.h>

namespace plumb {
namespace {

/// What a function of an angle in units of a 360th of a turn gives: rounded to the nearest double, and the rest of it.
PreciseValue of_angle(int (*function)(mpfr_ptr, mpfr_srcptr, unsigned long, mpfr_rnd_t), double degrees) {
  mpfr_t angle, result, rest;
  mpfr_inits2(53, angle, result, static_cast<mpfr_ptr>(nullptr));
  mpfr_init2(rest, 120);
  mpfr_set_d(angle, degrees, MPFR_RNDN);
  function(result, angle, 360, MPFR_RNDN);
  function(rest, angle, 360, MPFR_RNDN);
  const double high = mpfr_get_d(result, MPFR_RNDN);
  mpfr_sub(rest, rest, result, MPFR_RNDN);
  const double low = mpfr_get_d(rest, MPFR_RNDN);
  mpfr_clears(angle, result, rest, static_cast<mpfr_ptr>(nullptr));
  return {high, low};
}

}  // namespace

CosSin cos_sin_degrees(double degrees) {
  const auto [cos, sin] = precise_cos_sin_degrees(degrees);
  return {cos.high, sin.high};
}

PreciseCosSin precise_cos_sin_degrees(double degrees) {
  return {of_angle(mpfr_cosu, degrees), of_angle(mpfr_sinu, degrees)};
}

}  // namespace plumb
