#include "reference/solid_round.h"

namespace plumb {
namespace {

/// Where the spacing of doubles is normal and the halves below are exact.
bool in_range(double x) { return std::fabs(x) > 0x1p-900 && std::fabs(x) < 0x1p1000; }

bool is_zero(const Ball& x) { return x.hi == 0 && x.lo == 0 && x.radius == 0; }

/// hi is the nearest double to all of the ball. The slack covers the rounding of the two sums.
bool rounds_to_hi(const Ball& x) {
  if (!in_range(x.hi)) return false;
  const double slack = round_up(x.radius) + 0x1p-50 * std::fabs(x.lo);
  return x.lo + slack < (next_double(x.hi) - x.hi) / 2 && slack - x.lo < (x.hi - previous_double(x.hi)) / 2;
}

}  // namespace

bool nearest_of_ball(const Ball& x, double& result) {
  if (is_zero(x)) {
    result = 0;
    return true;
  }
  result = x.hi;
  return rounds_to_hi(x);
}

bool round_ball(const Ball& x, Rounded& result) {
  if (!nearest_of_ball(x, result.nearest)) return false;
  if (x.lo == 0 && x.radius == 0) {
    result.enclosure = {result.nearest, result.nearest};
    return true;
  }
  if (!(std::fabs(x.lo) > x.radius)) return false;
  result.enclosure = x.lo > 0 ? Enclosure{x.hi, next_double(x.hi)} : Enclosure{previous_double(x.hi), x.hi};
  return true;
}

bool ball_to_grid(const Ball& x, double& result) {
  if (!(std::fabs(x.hi) <= 1)) return false;
  const double scaled = x.hi * 0x1p52;
  double whole = std::nearbyint(scaled);
  const double low = x.lo * 0x1p52;
  const double radius = round_up(x.radius) * 0x1p52;
  // Exact: both are multiples of the last place of `scaled`. At a half (the last place of hi is finer than the grid by
  // a bit in the upper octave) the rest decides.
  const double fraction = scaled - whole;
  if (std::fabs(fraction) == 0.5) {
    if (!(std::fabs(low) > radius)) return false;
    if ((low > 0) == (fraction > 0)) whole += 2 * fraction;
  } else if (!(round_up(std::fabs(low) + radius) < 0.5 - std::fabs(fraction))) {
    return false;
  }
  result = whole * 0x1p-52 + 0.0;
  return true;
}

}  // namespace plumb
