#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "reference/exact_hit.h"
#include "reference/solid_ball.h"

namespace plumb {

/// A real number rounded: the doubles next to it and the nearest (ties to even; zero is +0).
struct Rounded {
  Enclosure enclosure;
  double nearest = 0;
};

/// Counts the doubles from zero: neighbours are one apart, both zeros are 0.
inline std::int64_t double_ordinal(double x) {
  const auto bits = std::bit_cast<std::int64_t>(x);
  return bits < 0 ? std::numeric_limits<std::int64_t>::min() - bits : bits;
}
inline double ordinal_double(std::int64_t n) {
  return std::bit_cast<double>(n < 0 ? std::numeric_limits<std::int64_t>::min() - n : n);
}
inline double next_double(double x) { return ordinal_double(double_ordinal(x) + 1); }
inline double previous_double(double x) { return ordinal_double(double_ordinal(x) - 1); }

/// The greatest n in [low, high) with at_least(n), which holds for `low`, fails for `high` and changes once. Starts at
/// `guess` and doubles its steps, so that a good guess costs two questions.
template <class AtLeast>
std::int64_t greatest_that(std::int64_t low, std::int64_t high, std::int64_t guess, const AtLeast& at_least) {
  // The ordinals of all doubles span more than an int64_t holds.
  const auto gap = [&] { return static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low); };
  const auto move = [](std::int64_t from, std::uint64_t step) {
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(from) + step);
  };
  if (guess <= low) guess = low + 1;
  if (guess >= high) guess = high - 1;
  const bool upwards = at_least(guess);
  (upwards ? low : high) = guess;
  for (std::uint64_t step = 1; gap() > step; step *= 2) {
    const std::int64_t probe = upwards ? move(low, step) : move(high, -step);
    const bool holds = at_least(probe);
    (holds ? low : high) = probe;
    if (holds != upwards) break;
  }
  while (gap() > 1) {
    const std::int64_t middle = move(low, gap() / 2);
    (at_least(middle) ? low : high) = middle;
  }
  return low;
}

/// Rounds by asking for exact signs: compare(scale, x, y) is the sign of scale value - (x + y), where scale is 1 or 2
/// and x, y are finite. `guess` may be anything; a near one saves time.
template <class Compare>
Rounded round_exactly(double guess, const Compare& compare) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  // The approximation of an exact zero is noise, far from it among the doubles.
  if (std::fabs(guess) < 0x1p-60 && compare(1, 0.0, 0.0) == 0) return {};
  const std::int64_t n = greatest_that(double_ordinal(-kInfinity), double_ordinal(kInfinity),
                                       std::isnan(guess) ? 0 : double_ordinal(guess),
                                       [&](std::int64_t k) { return compare(1, ordinal_double(k), 0.0) >= 0; });
  const double below = ordinal_double(n);
  if (std::isfinite(below) && compare(1, below, 0.0) == 0) return {{below, below}, below};
  const double above = ordinal_double(n + 1);
  // Half a spacing beyond the largest double the infinity begins, by IEEE 754.
  const int side = above == kInfinity    ? compare(1, kLargest, 0x1p970)
                   : below == -kInfinity ? compare(1, -kLargest, -0x1p970)
                                         : compare(2, below, above);
  const bool even_below = (n & 1) == 0;
  return {{below, above}, side > 0 || (side == 0 && !even_below) ? above : below};
}

/// The number in [-1, 1] rounded to a multiple of 2^-52, ties to even. compare(x) is the exact sign of value - x.
template <class Compare>
double round_to_grid(double guess, const Compare& compare) {
  constexpr std::int64_t kOne = std::int64_t{1} << 52;
  // k is the greatest whole number for which value >= (k - 1/2) 2^-52.
  const auto start = std::fabs(guess) <= 1 ? static_cast<std::int64_t>(std::nearbyint(guess * 0x1p52)) : 0;
  const auto lower_edge = [](std::int64_t k) { return static_cast<double>(2 * k - 1) * 0x1p-53; };
  std::int64_t k = greatest_that(-kOne, kOne + 1, start, [&](std::int64_t m) { return compare(lower_edge(m)) >= 0; });
  if ((k & 1) != 0 && k > -kOne && compare(lower_edge(k)) == 0) --k;
  return static_cast<double>(k) * 0x1p-52;
}

/// The nearest float (ties to even) of what lies in the enclosure. No midpoint of floats lies between neighbouring
/// doubles, so of the two the odd one stands for all that is strictly between.
inline float nearest_float(const Enclosure& e) {
  const bool odd_below = (std::bit_cast<std::int64_t>(e.below) & 1) != 0;
  return static_cast<float>(e.exact() || odd_below ? e.below : e.above) + 0.0F;
}

/// The same roundings of a ball; false if it does not decide.
bool round_ball(const Ball& x, Rounded& result);
bool nearest_of_ball(const Ball& x, double& result);
bool ball_to_grid(const Ball& x, double& result);

}  // namespace plumb
