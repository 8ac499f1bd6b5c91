#include "conformance/growth/growth_pilot.h"

#include <algorithm>
#include <cmath>

namespace plumb {
namespace {

constexpr double kFewestRays = 64;
/// A picture of 2048 x 2048, and a strip as high as most programs' pictures may be: far more than any program needs
/// whose rays cost anything.
constexpr double most_rays(GrowthView view) { return view == GrowthView::oblique ? 4'194'304 : kMostStripRays; }
/// Of the time of a run that has no rays to speak of: what the highest resolution must add to be told from its noise.
constexpr double kShareOfFixed = 0.5;
constexpr int kMostRaises = 3;

/// How far the middle of three resolutions may lie off the line through the others: 10 % of what it spans, and what two
/// runs of the same program differ by anyway.
bool collinear(const TimedRun& low, const TimedRun& middle, const TimedRun& high) {
  const double span = high.seconds - low.seconds;
  const double expected = low.seconds + span * (middle.rays - low.rays) / (high.rays - low.rays);
  return std::abs(middle.seconds - expected) <= 0.10 * span + 0.03 * high.seconds;
}

GrowthCell cell_of(const TimedRun& run) { return {run.rays, {run.seconds}}; }

/// The cost of a ray grows from size to size as it did last, but by no more than 4; without a size before, `otherwise`.
double guessed_rays(double last, double before, double demand, double otherwise) {
  if (last == 0) return otherwise;
  const double growth = before == 0 ? 1.5 : std::clamp(last / before, 1.0, 4.0);
  return 1.3 * demand / (last * growth);
}

}  // namespace

/// More and more rays, until they take `demand` seconds more than none, or more would pass the limit of a run.
std::optional<TimedRun> GrowthPilot::settle(std::size_t index, GrowthView view, double rays, double base_seconds,
                                            double demand) {
  std::optional<TimedRun> most;
  for (;;) {
    rays = std::clamp(rays, kFewestRays, most_rays(view));
    const std::optional<TimedRun> run = meter_.run(index, view, rays, 0);
    if (!run) return most;
    most = run;
    const double gained = run->seconds - base_seconds;
    if (gained >= demand || run->rays >= 0.9 * most_rays(view)) return most;
    rays = run->rays * std::clamp(1.5 * demand / std::max(gained, demand / 8), 2.0, 8.0);
  }
}

GrowthPilot::Result GrowthPilot::choose(std::size_t index, double size, double affordable_seconds) {
  Result result;
  result.runs.size = size;
  const std::optional<TimedRun> fewest = meter_.run(index, GrowthView::oblique, kFewestRays, 0);
  result.over_limit = !fewest;
  if (!fewest) return result;
  result.runs.fewest = cell_of(*fewest);
  result.too_dear = fewest->seconds > affordable_seconds;
  if (result.too_dear) return result;
  const double demand = std::max(least_seconds_, kShareOfFixed * fewest->seconds);

  const double first_guess = guessed_rays(last_.oblique, before_.oblique, demand, 4096);
  auto high = settle(index, GrowthView::oblique, first_guess, fewest->seconds, demand);
  if (!high) return result;
  std::optional<TimedRun> low = fewest;
  bool is_raised = false;
  auto middle = meter_.run(index, GrowthView::oblique, high->rays / 2, 0);
  for (int raise = 0; middle && raise < kMostRaises && high->rays < most_rays(GrowthView::oblique) / 4; ++raise) {
    if (collinear(*low, *middle, *high)) break;
    low = high;
    is_raised = true;
    high = settle(index, GrowthView::oblique, 4 * low->rays, low->seconds, demand);
    if (!high) return result;
    middle = meter_.run(index, GrowthView::oblique, (low->rays + high->rays) / 2, 0);
  }
  if (!middle) return result;
  const double slope = std::max(high->seconds - low->seconds, 0.1 * demand) / (high->rays - low->rays);
  const double fixed = std::max(low->seconds - slope * low->rays, 0.0);
  const auto axis =
      settle(index, GrowthView::axis_aligned,
             guessed_rays(last_.axis_aligned, before_.axis_aligned, demand, high->rays / 4), fixed, demand);
  if (!axis) return result;
  before_ = last_;
  last_ = {slope, std::max(axis->seconds - fixed, 0.1 * demand) / axis->rays, 0};
  if (is_raised) result.runs.low = cell_of(*low);
  result.runs.middle = cell_of(*middle);
  result.runs.high = cell_of(*high);
  result.runs.axis_aligned = cell_of(*axis);
  return result;
}

}  // namespace plumb
