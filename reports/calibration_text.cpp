#include "reports/calibration_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace plumb {
namespace {

/// The probability of `wrong` or fewer of `of` at a rate.
double at_most(int wrong, int of, double rate) {
  double sum = 0;
  for (int k = 0; k <= wrong; ++k)
    sum += std::exp(std::lgamma(of + 1.0) - std::lgamma(k + 1.0) - std::lgamma(of - k + 1.0) + k * std::log(rate) +
                    (of - k) * std::log1p(-rate));
  return sum;
}

double median_seconds(std::vector<double> seconds) {
  if (seconds.empty()) return 0;
  const auto middle = seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2);
  std::ranges::nth_element(seconds, middle);
  return *middle;
}

struct Tally {
  int decisions = 0, wrong = 0, undecided = 0;
  void add(const CalibrationDecision& d) {
    ++decisions;
    if (d.found == GrowthDecision::undecided)
      ++undecided;
    else if (d.found != d.expected)
      ++wrong;
  }
  std::string text() const { return fmt::format("{} / {} / {}", decisions, wrong, undecided); }
};

std::string rate_line(const std::string& what, std::span<const CalibrationDecision> all,
                      const std::function<bool(const CalibrationDecision&)>& counts) {
  Tally tally;
  for (const CalibrationDecision& d : all)
    if (counts(d)) tally.add(d);
  return fmt::format("- {}: {} of {} (<= {:.1f} % at 95 %)\n", what, tally.wrong, tally.decisions,
                     100 * upper_rate(tally.wrong, tally.decisions));
}

}  // namespace

double upper_rate(int wrong, int of) {
  if (wrong >= of) return 1;
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (at_most(wrong, of, middle) > 0.05 ? low : high) = middle;
  }
  return high;
}

std::string calibration_text(std::span<const CalibrationDecision> all) {
  struct Row {
    GrowthDecision expected = GrowthDecision::undecided;
    Tally quiet, loaded;
    std::vector<double> seconds;
    double least = 1e9, most = -1e9;
  };
  std::map<std::pair<std::string, std::string>, Row> rows;
  Tally total;
  std::vector<double> seconds, quiet_seconds;
  for (const CalibrationDecision& d : all) {
    Row& row = rows[{d.subject, d.gate}];
    row.expected = d.expected;
    (d.loaded ? row.loaded : row.quiet).add(d);
    row.seconds.push_back(d.seconds);
    row.least = std::min(row.least, d.slope), row.most = std::max(row.most, d.slope);
    total.add(d);
    seconds.push_back(d.seconds);
    if (!d.loaded) quiet_seconds.push_back(d.seconds);
  }
  std::string text =
      "| program | question | right answer | alone: decided / wrong / undecided | under load | slopes | median s |\n"
      "| --- | --- | --- | --- | --- | --- | --- |\n";
  for (const auto& [name, row] : rows)
    text += fmt::format("| {} | {} | {} | {} | {} | {:.2f} to {:.2f} | {:.0f} |\n", name.first, name.second,
                        to_string(row.expected), row.quiet.text(), row.loaded.text(), row.least, row.most,
                        median_seconds(row.seconds));
  text += fmt::format(
      "\n{} decisions, {} wrong, {} undecided ({:.1f} %); median time of a gate {:.1f} s, alone {:.1f} s\n\n",
      total.decisions, total.wrong, total.undecided, total.decisions ? 100.0 * total.undecided / total.decisions : 0.0,
      median_seconds(seconds), median_seconds(quiet_seconds));
  const auto of = [](GrowthDecision expected, bool loaded) {
    return [=](const CalibrationDecision& d) { return d.expected == expected && d.loaded == loaded; };
  };
  text += rate_line("false passes, alone", all, of(GrowthDecision::fail, false));
  text += rate_line("false passes, under load", all, of(GrowthDecision::fail, true));
  text += rate_line("false fails, alone", all, of(GrowthDecision::pass, false));
  text += rate_line("false fails, under load", all, of(GrowthDecision::pass, true));
  text += rate_line("wrong, of all", all, [](const CalibrationDecision&) { return true; });
  return text;
}

}  // namespace plumb
