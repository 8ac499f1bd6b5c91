#include "reports/growth_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/gnuplot_panels.h"

namespace plumb {
namespace {

constexpr double kMicro = 1e6;

std::string slope_text(const GrowthSlope& slope) {
  return fmt::format("{:.2f}  (between {:.2f} and {:.2f})", slope.slope, slope.low, slope.high);
}

/// In words: what happens where there are four times as many.
std::string four_times(double slope) {
  const double factor = std::pow(4, slope);
  if (factor < 1.05) return "as long as before";
  return fmt::format("{:.1f} times as long", factor);
}

std::string meaning(const GrowthFigures& f) {
  const GrowthCurve& slowest =
      *std::ranges::max_element(f.views, {}, [](const GrowthCurve& view) { return view.slope.slope; });
  std::string text = fmt::format("With four times as many {}, a ray takes {} ({} view), and building {}.\n", f.of,
                                 four_times(slowest.slope.slope), slowest.name, four_times(f.building.slope.slope));
  if (f.trace == GrowthDecision::fail) {
    text += fmt::format(
        "A search that looks at all of them has slope 1, one through a good hierarchy 0.1 to 0.3. This is the former: "
        "at a million {} a\n"
        "picture of 640 x 480 would take about {:.2g} s.\n",
        f.of,
        640 * 480 * slowest.points.back().seconds * std::pow(1e6 / slowest.points.back().size, slowest.slope.slope));
  }
  if (f.build == GrowthDecision::fail)
    text +=
        "A build that sorts at each level has slope 1.1, one that looks at all pairs 2. This one is nearer the "
        "latter.\n";
  return text;
}

LabelledLine guide(std::size_t series, const GrowthPoint& from, double to_size, double slope) {
  return {series,
          {{from.size, from.seconds * kMicro, ""},
           {to_size, from.seconds * kMicro * std::pow(to_size / from.size, slope), ""}},
          false};
}

}  // namespace

std::string growth_text(const GrowthFigures& f) {
  std::string text;
  if (!f.views.empty()) {
    text += fmt::format("{:>12}", f.of);
    for (const GrowthCurve& view : f.views) text += fmt::format("{:>20}", view.name);
    text += fmt::format("{:>14}\n{:>12}", "build", "");
    for (std::size_t i = 0; i < f.views.size(); ++i) text += fmt::format("{:>20}", "microseconds a ray");
    text += fmt::format("{:>14}\n", "seconds");
    for (std::size_t i = 0; i < f.building.points.size(); ++i) {
      text += fmt::format("{:>12.0f}", f.building.points[i].size);
      for (const GrowthCurve& view : f.views)
        text += i < view.points.size() ? fmt::format("{:>20.3f}", view.points[i].seconds * kMicro)
                                       : fmt::format("{:>20}", "-");
      text += fmt::format("{:>14.3f}\n", f.building.points[i].seconds);
    }
    text += "\nslope in a log-log plot:\n";
    for (const GrowthCurve& view : f.views) text += fmt::format("  {:<14}{}\n", view.name, slope_text(view.slope));
    text += fmt::format("  {:<14}{}, over the top two octaves\n", "build", slope_text(f.building.slope));
    text += fmt::format("trace: {} (pass below 0.5, fail above 0.6)   build: {} (fail above 1.5)\n\n",
                        to_string(f.trace), to_string(f.build));
    text += meaning(f);
  }
  text += fmt::format(
      "{} runs in {} round{}{}, {:.1f} s of processor time, {:.1f} s on the clock; start-up {:.3f} s; seed {}\n",
      f.runs, f.rounds, f.rounds == 1 ? "" : "s", f.attempts > 1 ? fmt::format(" of attempt {}", f.attempts) : "",
      f.cpu_seconds, f.wall_seconds, f.start_seconds, f.seed);
  for (const std::string& note : f.notes) text += note + "\n";
  return text;
}

ReportFile growth_plot(const GrowthFigures& f) {
  std::vector<SeriesStyle> styles;
  std::vector<LabelledLine> lines;
  for (const GrowthCurve& view : f.views) {
    lines.push_back({styles.size(), {}, false});
    styles.push_back({fmt::format("{}: slope {:.2f}", view.name, view.slope.slope), styles.size(), false});
    for (const GrowthPoint& point : view.points)
      lines.back().points.push_back({point.size, point.seconds * kMicro, ""});
  }
  if (!f.views.empty() && !f.views[0].points.empty()) {
    const GrowthPoint& first = f.views[0].points.front();
    const double last = f.views[0].points.back().size;
    for (const auto& [name, slope] :
         {std::pair{"in proportion: slope 1", 1.0}, std::pair{"the limit: slope 0.5", 0.5}}) {
      lines.push_back(guide(styles.size(), first, last, slope));
      styles.push_back({name, styles.size() + 2, true});
    }
  }
  const FigureText text{"Processor time of a ray against the size of the scene",
                        f.of,
                        "microseconds a ray",
                        {fmt::format("trace: {}, build: {}", to_string(f.trace), to_string(f.build)),
                         fmt::format("build slope {:.2f}", f.building.slope.slope)}};
  return {"growth.gnuplot", lines_script(text, styles, lines)};
}

}  // namespace plumb
