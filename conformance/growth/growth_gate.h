#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "conformance/results/growth_results.h"
#include "conformance/verdict.h"

namespace plumb {

/// How the scene is looked at: from somewhere in between the axes, or exactly along one, in a narrow picture of an odd
/// width, so that the rays of its middle column have a direction with an exact 0 in it.
enum class GrowthView { oblique, axis_aligned };

/// One run of the program.
struct GrowthQuestion {
  /// Which size of scene; none: a scene with next to nothing in it.
  std::optional<std::size_t> size;
  GrowthView view = GrowthView::oblique;
  int width = 0, height = 0;
  /// All runs of a round have the same camera.
  int round = 0;
};

struct GrowthAnswer {
  /// Of the program and all its descendants.
  double cpu_seconds = 0;
  /// On the clock, with everything that belongs to the run.
  double wall_seconds = 0;
  /// It was stopped at its limit of processor time.
  bool over_limit = false;
};

/// Runs the program once. What makes timing pointless (a crash, a wrong picture) is thrown as GrowthStop.
using GrowthAsk = std::function<GrowthAnswer(const GrowthQuestion&)>;

/// The end of a gate for another reason than time: the verdict of both of its cases.
class GrowthStop : public std::runtime_error {
 public:
  explicit GrowthStop(CheckResult result) : std::runtime_error(result.summary), result_(std::move(result)) {}
  const CheckResult& result() const { return result_; }

 private:
  CheckResult result_;
};

struct GrowthSettings {
  /// How much there is in the scene, ascending; the last at least 64 times the first.
  std::vector<double> sizes;
  std::string of = "triangles";
  /// The program's processor time from its lowest to its highest resolution, at least.
  double least_seconds = 0.15;
  /// On the clock, for all of it.
  double budget_seconds = 300;
  /// Of processor time for one run; for messages.
  double run_seconds = 60;
  std::uint64_t seed = 1;
  /// Told what is being measured; may be empty.
  std::function<void(const std::string&)> progress = nullptr;
};

/// Decides whether a program's time a ray grows sublinearly with the size of the scene, and its time to build not much
/// faster than linearly (docs/growth-gate.md has the rule and what it rests on).
///
/// Each size is rendered at three resolutions in an oblique view and at one in an axis-aligned view: what start-up,
/// reading and building cost is the same for all of them, so the slope of processor time over rays is the cost of a
/// ray, and the intercept, less a run on next to nothing, that of building. Resolutions are raised until the three lie
/// on a line within 10 % (just-in-time compilers) and the times differ by `least_seconds`. Rounds over all sizes
/// follow, up to five, fewer when the answer is sure; where five do not decide, it is tried again with three times the
/// rays, at most three times.
///
/// A size that takes too long for the budget is only timed once, for its building, if the sizes below it span 64 times;
/// otherwise GrowthStop with the verdict `timeout`. Undecided, or out of budget: `undecided`, with a note.
GrowthFigures run_growth_gate(const GrowthSettings& settings, const GrowthAsk& ask);

}  // namespace plumb
