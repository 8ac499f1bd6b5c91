#pragma once

namespace plumb {

/// The cosine and sine of an angle in degrees.
struct CosSin {
  double cos, sin;
};

/// Both values correctly rounded (MPFR), so they are the same bits on every machine and exact at
/// multiples of 90 degrees. NaN for an angle that is NaN or infinite.
CosSin cos_sin_degrees(double degrees);

}  // namespace plumb
