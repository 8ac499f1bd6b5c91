#include "conformance/growth/growth_gate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "conformance/families/random.h"
#include "conformance/growth/growth_fit.h"
#include "conformance/growth/growth_meter.h"
#include "conformance/growth/growth_pilot.h"

namespace plumb {
namespace {

constexpr double kSpan = 64;
constexpr int kRounds = 5;
constexpr int kAttempts = 4;
/// With fewer rounds than five the interval must be wider and clear of the threshold by a margin, for it is looked at
/// after every round.
constexpr double kEarlyConfidence = 0.999, kEarlyMargin = 0.05;
constexpr double kLastConfidence = 0.95;
/// A size is traced if a run on it takes no more than this share of the budget: it will be run a dozen times and more.
/// More is spent on the sizes without which nothing can be said.
constexpr double kAffordableShare = 1.0 / 40, kNeededShare = 1.0 / 12;
/// After so many rounds an interval this wide will not become narrow enough; more rays would make it so.
constexpr int kRoundsToJudgeBy = 3;
constexpr double kHopelessWidth = 1.2;
/// How many times the rays of the attempt before.
constexpr double kMoreRays = 3;

class Gate {
 public:
  Gate(const GrowthSettings& settings, const GrowthAsk& ask) : settings_(settings), meter_(settings, ask) {
    figures_.of = settings.of;
    figures_.seed = settings.seed;
  }

  GrowthFigures run() {
    try {
      for (int attempt = 0; attempt < kAttempts && !decided(); ++attempt) {
        figures_.attempts = attempt + 1;
        try_once(settings_.least_seconds * std::pow(kMoreRays, attempt));
      }
      if (!decided())
        figures_.notes.push_back(fmt::format(
            "not decided after {} attempts: the slope lies too near a threshold for what this machine resolves",
            kAttempts));
    } catch (const GrowthUndecided& reason) {
      figures_.notes.push_back(reason.what());
    }
    figures_.runs = meter_.runs();
    figures_.cpu_seconds = meter_.cpu_seconds();
    figures_.wall_seconds = meter_.wall_seconds();
    return std::move(figures_);
  }

 private:
  bool decided() const {
    return figures_.trace != GrowthDecision::undecided && figures_.build != GrowthDecision::undecided;
  }

  void try_once(double least_seconds) {
    runs_ = {};
    figures_.trace = figures_.build = GrowthDecision::undecided;
    measure_start(0);
    choose_resolutions(least_seconds);
    // The first round is the one that the resolutions were chosen by: mostly the answer is clear by then.
    decide(1);
    for (int round = 1; round < kRounds && !decided(); ++round) {
      measure_round(round);
      if (!decide(round + 1)) break;
    }
  }

  void measure_start(int round) {
    const auto run = meter_.run(std::nullopt, GrowthView::oblique, 0, round);
    if (!run) throw GrowthStop(too_slow("a scene with a dozen triangles"));
    runs_.start.seconds.push_back(run->seconds);
  }

  void choose_resolutions(double least_seconds) {
    GrowthPilot pilot(meter_, least_seconds);
    for (std::size_t i = 0; i < settings_.sizes.size(); ++i) {
      say(i, 0);
      const bool needed = i == 0 || settings_.sizes[i - 1] < kSpan * settings_.sizes[0];
      const double share = needed ? kNeededShare : kAffordableShare;
      const GrowthPilot::Result found = pilot.choose(i, settings_.sizes[i], share * settings_.budget_seconds);
      if (!found.runs.is_traced()) return end_sizes(i, found);
      runs_.sizes.push_back(found.runs);
    }
  }

  /// Size `i` takes too long to be traced.
  void end_sizes(std::size_t i, const GrowthPilot::Result& found) {
    if (!found.over_limit && !found.too_dear)
      throw GrowthUndecided(fmt::format("the times with {:.0f} {} differ too much to choose a resolution by",
                                        settings_.sizes[i], settings_.of));
    const std::string what = fmt::format("the scene with {:.0f} {}", settings_.sizes[i], settings_.of);
    if (i == 0 || settings_.sizes[i - 1] < kSpan * settings_.sizes[0]) {
      if (figures_.attempts > 1) throw GrowthUndecided(what + " took longer than in the attempt before");
      throw GrowthStop(too_slow(what));
    }
    runs_.sizes.push_back(found.runs);
    runs_.last_is_bound = found.over_limit;
    if (found.over_limit) runs_.sizes.back().fewest = {0, {settings_.run_seconds}};
    if (figures_.attempts == 1)
      figures_.notes.push_back(fmt::format("{} takes {}{:.3g} s a run: it was timed once, for its building alone", what,
                                           found.over_limit ? "more than " : "", runs_.sizes.back().fewest.seconds[0]));
  }

  CheckResult too_slow(const std::string& what) const {
    CheckResult result;
    result.verdict = Verdict::timeout;
    result.cause = "cpu_time";
    result.summary = what + " takes too long to be measured";
    result.advice = "look for a search that tries every triangle for each ray, and for a build that compares all pairs";
    return result;
  }

  void measure_round(int round) {
    measure_start(round);
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < runs_.sizes.size(); ++i)
      if (runs_.sizes[i].is_traced()) order.push_back(i);
    Random random(settings_.seed, "growth-order", static_cast<std::uint64_t>(16 * figures_.attempts + round));
    for (std::size_t i = order.size(); i > 1; --i)
      std::swap(order[i - 1], order[random.below(static_cast<std::uint32_t>(i))]);
    for (const std::size_t i : order) {
      say(i, round);
      GrowthSizeRuns& size = runs_.sizes[i];
      for (GrowthCell* cell : {&size.fewest, &size.low, &size.middle, &size.high})
        if (cell->rays > 0) time(i, GrowthView::oblique, round, *cell);
      time(i, GrowthView::axis_aligned, round, size.axis_aligned);
    }
  }

  void time(std::size_t size, GrowthView view, int round, GrowthCell& cell) {
    const auto run = meter_.run(size, view, cell.rays, round);
    if (!run)
      throw GrowthUndecided(fmt::format("a run on {:.0f} {} took more than {:g} s, which it had not done before",
                                        settings_.sizes[size], settings_.of, settings_.run_seconds));
    cell.seconds.push_back(run->seconds);
  }

  /// Whether another round could help.
  bool decide(int rounds) {
    const bool last = rounds == kRounds;
    const GrowthSlopes slopes = growth_slopes(runs_, last ? kLastConfidence : kEarlyConfidence, settings_.seed);
    const double margin = last ? 0 : kEarlyMargin;
    figures_.rounds = rounds;
    // One view that fails is enough; to pass takes all of them.
    const GrowthDecision views[] = {trace_decision(slopes.oblique, margin),
                                    trace_decision(slopes.axis_aligned, margin)};
    figures_.trace = std::ranges::count(views, GrowthDecision::fail) > 0    ? GrowthDecision::fail
                     : std::ranges::count(views, GrowthDecision::pass) == 2 ? GrowthDecision::pass
                                                                            : GrowthDecision::undecided;
    decide_build(slopes.build, margin, last);
    draw_curves(slopes);
    const auto width = [](const GrowthSlope& slope) { return slope.high - slope.low; };
    return rounds < kRoundsToJudgeBy || std::max(width(slopes.oblique), width(slopes.axis_aligned)) < kHopelessWidth;
  }

  void decide_build(const GrowthSlope& slope, double margin, bool last) {
    figures_.building.slope = slope;
    figures_.build = build_decision(slope, margin, last);
    if (!runs_.last_is_bound || figures_.build == GrowthDecision::fail) return;
    // That the largest takes at least so long tells nothing more; the two below it were timed.
    GrowthRuns timed = runs_;
    timed.sizes.pop_back();
    figures_.building.slope = growth_slopes(timed, last ? kLastConfidence : kEarlyConfidence, settings_.seed).build;
    figures_.build = build_decision(figures_.building.slope, margin, last);
  }

  void draw_curves(const GrowthSlopes& slopes) {
    GrowthCurve oblique{.name = "oblique", .points = {}, .slope = slopes.oblique};
    GrowthCurve axis_aligned{.name = "axis-aligned", .points = {}, .slope = slopes.axis_aligned};
    figures_.building.name = "build";
    figures_.building.points.clear();
    const std::vector<GrowthTimes> times = times_of(runs_);
    for (std::size_t i = 0; i < times.size(); ++i) {
      const double size = runs_.sizes[i].size;
      figures_.building.points.push_back({size, times[i].build});
      if (!runs_.sizes[i].is_traced()) continue;
      oblique.points.push_back({size, times[i].oblique});
      axis_aligned.points.push_back({size, times[i].axis_aligned});
    }
    figures_.views = {std::move(oblique), std::move(axis_aligned)};
    figures_.start_seconds = median(runs_.start.seconds);
  }

  void say(std::size_t size, int round) const {
    if (settings_.progress)
      settings_.progress(fmt::format("{:.0f} {}, round {}{}", settings_.sizes[size], settings_.of, round + 1,
                                     figures_.attempts > 1 ? fmt::format(" of attempt {}", figures_.attempts) : ""));
  }

  const GrowthSettings& settings_;
  GrowthMeter meter_;
  GrowthFigures figures_;
  GrowthRuns runs_;
};

}  // namespace

GrowthFigures run_growth_gate(const GrowthSettings& settings, const GrowthAsk& ask) {
  if (settings.sizes.size() < 2 || !std::ranges::is_sorted(settings.sizes) ||
      settings.sizes.back() < kSpan * settings.sizes.front())
    throw std::invalid_argument("run_growth_gate: the sizes must ascend and span 64 times");
  return Gate(settings, ask).run();
}

}  // namespace plumb
