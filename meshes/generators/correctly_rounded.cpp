#include "meshes/generators/correctly_rounded.h"

#include <mpfr.h>

namespace plumb {

std::vector<SinCos> parts_of_a_turn(std::uint32_t parts) {
  std::vector<SinCos> table(parts);
  mpfr_t part, value;
  mpfr_init2(part, 53);
  mpfr_init2(value, 53);  // of a double: what MPFR rounds to it is not rounded again
  for (std::uint32_t k = 0; k < parts; ++k) {
    mpfr_set_ui(part, k, MPFR_RNDN);
    mpfr_sinu(value, part, parts, MPFR_RNDN);
    table[k].sin = mpfr_get_d(value, MPFR_RNDN);
    mpfr_cosu(value, part, parts, MPFR_RNDN);
    table[k].cos = mpfr_get_d(value, MPFR_RNDN);
  }
  mpfr_clear(value);
  mpfr_clear(part);
  return table;
}

}  // namespace plumb
