#pragma once

namespace plumb {

/// The cosine and sine of an angle in degrees.
struct CosSin {
  double cos, sin;
};

/// Both values correctly rounded (MPFR), so they are the same bits on every machine and exact at
/// multiples of 90 degrees. NaN for an angle that is NaN or infinite.
CosSin cos_sin_degrees(double degrees);

/// A value in two doubles, of which `low` is what is missing in `high`.
struct PreciseValue {
  double high, low;
};
struct PreciseCosSin {
  PreciseValue cos, sin;
};

/// The same with twice the digits: `high` is what cos_sin_degrees gives, and both together are within 2^-106 of the
/// value itself.
PreciseCosSin precise_cos_sin_degrees(double degrees);

}  // namespace plumb
