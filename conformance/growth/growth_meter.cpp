#include "conformance/growth/growth_meter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumb {
namespace {

constexpr int kLeastSide = 8;

}  // namespace

std::optional<TimedRun> GrowthMeter::run(std::optional<std::size_t> size, GrowthView view, double rays, int round) {
  if (wall_seconds_ >= settings_.budget_seconds)
    throw GrowthUndecided(fmt::format("not decided within {:.0f} s on the clock", settings_.budget_seconds));
  GrowthQuestion question{.size = size, .view = view, .width = 0, .height = 0, .round = round};
  if (view == GrowthView::oblique) {
    question.width = question.height = std::max(kLeastSide, static_cast<int>(std::lround(std::sqrt(rays))));
  } else {
    question.width = kStripWidth;
    question.height = std::max(kLeastSide, static_cast<int>(std::lround(rays / kStripWidth)));
  }
  const GrowthAnswer answer = ask_(question);
  ++runs_;
  cpu_seconds_ += answer.cpu_seconds;
  wall_seconds_ += answer.wall_seconds;
  if (answer.over_limit) return std::nullopt;
  return TimedRun{static_cast<double>(question.width) * question.height, answer.cpu_seconds};
}

}  // namespace plumb
