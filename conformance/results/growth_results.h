#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace plumb {

/// What the growth gate says of one of its two questions.
enum class GrowthDecision { pass, fail, undecided };

/// As it stands in files: `pass`.
constexpr const char* to_string(GrowthDecision decision) {
  return decision == GrowthDecision::pass ? "pass" : decision == GrowthDecision::fail ? "fail" : "undecided";
}

/// A slope in a log-log plot, and the interval that holds it.
struct GrowthSlope {
  double slope = 0, low = 0, high = 0;
};

/// What was measured at one size.
struct GrowthPoint {
  double size = 0;
  double seconds = 0;
};

/// One curve: processor time a ray in one view, or of building, over the size of the scene.
struct GrowthCurve {
  /// `oblique`, `axis-aligned`, `build`
  std::string name;
  std::vector<GrowthPoint> points;
  GrowthSlope slope;
};

/// What the growth gate measured of one program, and what it says of it (docs/growth-gate.md). All of it is measured:
/// it stands with a case's usage, never in what has to be the same in every run.
struct GrowthFigures {
  /// What there is more and more of: `triangles` or `objects`.
  std::string of = "triangles";
  GrowthDecision trace = GrowthDecision::undecided;
  GrowthDecision build = GrowthDecision::undecided;
  /// Processor time a ray, a curve a view; and processor time of a whole run less start-up and tracing.
  std::vector<GrowthCurve> views;
  GrowthCurve building;
  /// Processor time of a run that has next to nothing to do.
  double start_seconds = 0;
  int attempts = 0, rounds = 0, runs = 0;
  /// Processor time of all runs, and time on the clock with the checks of their pictures.
  double cpu_seconds = 0, wall_seconds = 0;
  std::uint64_t seed = 0;
  /// What was left out, and why nothing was decided, a sentence each.
  std::vector<std::string> notes;
};

/// One decision of a gate about a program that is known.
struct CalibrationDecision {
  std::string subject;
  /// The case of the suite: `mesh-trace`.
  std::string gate;
  /// Whether other programs ran at the same time.
  bool loaded = false;
  GrowthDecision expected = GrowthDecision::undecided, found = GrowthDecision::undecided;
  /// Verdict and cause, as in results.
  std::string verdict, cause;
  double slope = 0;
  /// Of the whole gate, on the clock.
  double seconds = 0;
  int attempts = 0;
  std::uint64_t seed = 0;
};

}  // namespace plumb
