#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace plumb {

/// The place of a double among all doubles in their order: neighbours differ by one, both zeros are 0, the infinities
/// are the ends. Not for NaN.
inline std::int64_t double_rank(double x) {
  const auto magnitude = static_cast<std::int64_t>(std::bit_cast<std::uint64_t>(std::fabs(x)));
  return std::signbit(x) ? -magnitude : magnitude;
}

/// The double at a rank; +0 at 0.
inline double double_at_rank(std::int64_t rank) {
  const double magnitude = std::bit_cast<double>(static_cast<std::uint64_t>(rank < 0 ? -rank : rank));
  return rank < 0 ? -magnitude : magnitude;
}

/// The smallest double for which `holds(x)` is true, where `holds` is false up to some double and true from there on.
/// It is asked for finite doubles only: -infinity is taken not to hold, +infinity to hold. Two questions suffice if
/// `guess` (NaN counts as 0) is the answer; the search gallops away from it.
template <class Holds>
double smallest_that_holds(double guess, const Holds& holds) {
  const std::int64_t end = double_rank(std::numeric_limits<double>::infinity());
  const auto holds_at = [&](std::int64_t rank) { return rank >= end || (rank > -end && holds(double_at_rank(rank))); };
  std::int64_t fails = std::isnan(guess) ? 0 : double_rank(guess);
  std::int64_t satisfies = fails;
  // Strides end at 2^61, so that no sum or difference of ranks (below 2^63) leaves 64 bits.
  const auto longer = [](std::int64_t stride) { return std::min(2 * stride, std::int64_t{1} << 61); };
  if (holds_at(fails)) {
    for (std::int64_t stride = 1; fails == satisfies || holds_at(fails); stride = longer(stride)) {
      satisfies = fails;
      fails = std::max(satisfies, stride - end) - stride;
    }
  } else {
    for (std::int64_t stride = 1; fails == satisfies || !holds_at(satisfies); stride = longer(stride)) {
      fails = satisfies;
      satisfies = std::min(fails, end - stride) + stride;
    }
  }
  while (satisfies - fails > 1) {
    const std::int64_t middle = fails + (satisfies - fails) / 2;
    (holds_at(middle) ? satisfies : fails) = middle;
  }
  return double_at_rank(satisfies);
}

}  // namespace plumb
