#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "conformance/results/growth_results.h"

namespace plumb {

/// Runs of one kind: the same scene in the same resolution, once a round. Seconds of processor time, > 0.
struct GrowthCell {
  double rays = 0;
  std::vector<double> seconds;
};

/// All runs on one size of scene.
struct GrowthSizeRuns {
  double size = 0;
  /// In the oblique view, with next to no rays: start-up, reading and building. The others are empty for a size that is
  /// only timed for its building.
  GrowthCell fewest;
  /// Further resolutions in that view, ascending. `low` is empty where `fewest` serves as the lowest of three.
  GrowthCell low, middle, high;
  GrowthCell axis_aligned;
  const GrowthCell& lowest() const { return low.seconds.empty() ? fewest : low; }
  bool is_traced() const { return !high.seconds.empty(); }
};

/// All runs of an attempt.
struct GrowthRuns {
  /// Of a scene with next to nothing in it.
  GrowthCell start;
  /// Ascending; those that are traced first.
  std::vector<GrowthSizeRuns> sizes;
  /// The last size was stopped at its limit: its time is what it takes at least.
  bool last_is_bound = false;
};

/// What runs on one size come to: processor time a ray, in each view, and what a run takes beside start-up and rays.
struct GrowthTimes {
  double oblique = 0, axis_aligned = 0, build = 0;
};

/// The times of each size, from the median of every cell: a ray costs the slope of the least-squares line of seconds
/// over rays through three resolutions; an axis-aligned ray what that view takes beyond the line's intercept; building
/// is what the run with next to no rays takes less those and start-up. None is less than what could be told from 0: a
/// ray a hundredth of a second over the rays that were added, building a millisecond.
std::vector<GrowthTimes> times_of(const GrowthRuns& runs);

struct GrowthSlopes {
  GrowthSlope oblique, axis_aligned;
  /// Over the top two octaves of the sizes.
  GrowthSlope build;
};

/// The slopes of log(time) over log(size) by least squares, and intervals that hold them with `confidence`, by a
/// bootstrap [Efron 1993]: the deviations of single runs from their cell's median (of logarithms, all cells together,
/// scaled for the medians taken from the same numbers) are drawn again for each run, and the whole computation from
/// medians on is done anew. Each draw is blurred by 1.5 % besides: runs agree no better than that, however well a few
/// may agree by luck. Where no run was repeated nothing is known of deviations: the blur is then four times what the
/// resolutions of a size are off their lines by, and at least 7 %. Requires two traced sizes; a cell needs one run. The
/// same input and seed give the same result.
GrowthSlopes growth_slopes(const GrowthRuns& runs, double confidence, std::uint64_t seed);

/// The rule of the gate for time a ray (docs/growth-gate.md): pass if the upper bound lies below 0.5 - margin, fail if
/// the lower one lies above 0.6 + margin.
GrowthDecision trace_decision(const GrowthSlope& slope, double margin);
/// For the time of building: fail if the lower bound lies above 1.5 + margin; else pass if the upper one lies below
/// 1.5 - margin, or the slope itself below 1.2 (building that takes no time to speak of has no narrow interval), or
/// this is the `last_word`.
GrowthDecision build_decision(const GrowthSlope& slope, double margin, bool last_word);

/// The line through points (x, y) by least squares. Two different x or more.
struct Line {
  double intercept = 0, slope = 0;
};
Line line_through(std::span<const double> x, std::span<const double> y);

/// The middle value, or the mean of the two in the middle. At least one.
double median(std::vector<double> values);

}  // namespace plumb
