#pragma once

#include <optional>
#include <stdexcept>
#include <string>

#include "conformance/growth/growth_gate.h"

namespace plumb {

/// A run that was timed: so many rays from the camera in so much processor time.
struct TimedRun {
  double rays = 0, seconds = 0;
};

/// The axis-aligned view is a strip of 15 columns: odd, so that there is a middle one, whose rays have an exact 0 in
/// their direction; narrow, so that it counts. At most 32,768 high: many formats and programs hold no more than 65,535.
constexpr int kStripWidth = 15;
constexpr double kMostStripRays = 15.0 * 32'768;

/// Thrown where the gate ends without a decision; says why.
class GrowthUndecided : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Asks for runs by their number of rays, and adds up what they took.
class GrowthMeter {
 public:
  /// Both must outlive this.
  GrowthMeter(const GrowthSettings& settings, const GrowthAsk& ask) : settings_(settings), ask_(ask) {}

  /// A run with about so many rays: as many as the nearest picture of the view's shape has. nullopt: stopped at its
  /// limit. Throws GrowthUndecided before a run that would begin after the budget is spent.
  std::optional<TimedRun> run(std::optional<std::size_t> size, GrowthView view, double rays, int round);

  int runs() const { return runs_; }
  double cpu_seconds() const { return cpu_seconds_; }
  double wall_seconds() const { return wall_seconds_; }

 private:
  const GrowthSettings& settings_;
  const GrowthAsk& ask_;
  int runs_ = 0;
  double cpu_seconds_ = 0, wall_seconds_ = 0;
};

}  // namespace plumb
