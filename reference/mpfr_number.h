#pragma once

#include <mpfr.h>

#include <utility>

namespace plumb {

/// Owns one number of MPFR. Starts as zero; assigning takes over the other's precision.
class MpfrNumber {
 public:
  MpfrNumber() : MpfrNumber(MPFR_PREC_MIN) {}
  explicit MpfrNumber(mpfr_prec_t bits) {
    mpfr_init2(value_, bits);
    mpfr_set_zero(value_, 1);
  }
  MpfrNumber(const MpfrNumber& other) {
    mpfr_init2(value_, other.bits());
    mpfr_set(value_, other.value_, MPFR_RNDN);
  }
  MpfrNumber(MpfrNumber&& other) noexcept : MpfrNumber() { mpfr_swap(value_, other.value_); }
  MpfrNumber& operator=(MpfrNumber other) noexcept {
    mpfr_swap(value_, other.value_);
    return *this;
  }
  ~MpfrNumber() { mpfr_clear(value_); }

  mpfr_ptr get() { return value_; }
  mpfr_srcptr get() const { return value_; }
  mpfr_prec_t bits() const { return mpfr_get_prec(value_); }

 private:
  mpfr_t value_;
};

}  // namespace plumb
