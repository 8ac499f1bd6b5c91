#pragma once

#include <optional>

#include "conformance/growth/growth_fit.h"
#include "conformance/growth/growth_meter.h"

namespace plumb {

/// Chooses the resolutions for each size, from the smallest on: with so many rays that their time shows, and that three
/// resolutions lie on a line.
class GrowthPilot {
 public:
  /// `least_seconds` of processor time between the lowest and the highest resolution; more where a run takes long
  /// anyway, by what its noise may be.
  GrowthPilot(GrowthMeter& meter, double least_seconds) : meter_(meter), least_seconds_(least_seconds) {}

  struct Result {
    /// The runs that it was settled with, one in each cell; of a size that takes too long, or whose times make no
    /// sense, the first of them.
    GrowthSizeRuns runs;
    /// Not even the lowest resolution came to its end within the limit.
    bool over_limit = false;
    /// It came to its end, but takes more than is affordable.
    bool too_dear = false;
  };
  /// `affordable_seconds`: for the run at the lowest resolution; one that takes more is not traced.
  Result choose(std::size_t index, double size, double affordable_seconds);

 private:
  std::optional<TimedRun> settle(std::size_t index, GrowthView view, double rays, double base_seconds, double demand);

  GrowthMeter& meter_;
  double least_seconds_;
  /// Time a ray of the last size and the one before it; 0: none yet.
  GrowthTimes last_, before_;
};

}  // namespace plumb
