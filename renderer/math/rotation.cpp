#include "renderer/math/rotation.h"

#include <mpfr.h>

namespace plumb {

CosSin cos_sin_degrees(double degrees) {
  // The angle is exact in 53 bits; mpfr_cosu and mpfr_sinu take it in units of a 360th of a turn and
  // round their result correctly to the precision of the target.
  mpfr_t angle, result;
  mpfr_inits2(53, angle, result, static_cast<mpfr_ptr>(nullptr));
  mpfr_set_d(angle, degrees, MPFR_RNDN);
  mpfr_cosu(result, angle, 360, MPFR_RNDN);
  const double cos = mpfr_get_d(result, MPFR_RNDN);
  mpfr_sinu(result, angle, 360, MPFR_RNDN);
  const double sin = mpfr_get_d(result, MPFR_RNDN);
  mpfr_clears(angle, result, static_cast<mpfr_ptr>(nullptr));
  return {cos, sin};
}

}  // namespace plumb
