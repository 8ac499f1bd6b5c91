#include "conformance/growth/growth_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "conformance/families/random.h"

namespace plumb {
namespace {

constexpr int kReplicates = 2000;
/// Two runs of one program on a shared machine differ by as much without any cause that would show again: 20 renderings
/// of one scene, at a load of 2 on two processors, had a standard deviation of 1.6 %.
constexpr double kBlur = 0.015;
/// Where no run was repeated, they are taken to differ by at least so much, and by so many times what the resolutions
/// of a size show of it.
constexpr double kLeastBlurUnrepeated = 0.07, kDoubt = 4;
/// Differences of processor time that are told from nothing.
constexpr double kLeastGain = 0.01, kLeastBuild = 0.001;

double mean(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Nearly normal, of mean 0 and standard deviation 1: the sum of twelve reals from [0, 1), less 6.
double nearly_normal(Random& random) {
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += random.unit();
  return sum;
}

template <class Runs, class Use>
void for_each_cell(Runs& runs, const Use& use) {
  use(runs.start);
  for (auto& size : runs.sizes) {
    for (auto* cell : {&size.fewest, &size.low, &size.middle, &size.high, &size.axis_aligned})
      if (!cell->seconds.empty()) use(*cell);
  }
}

/// The deviations of logarithms from their cell's median, scaled up for the medians taken from the same numbers.
std::vector<double> deviations(const GrowthRuns& runs) {
  std::vector<double> all;
  std::size_t cells = 0;
  for_each_cell(runs, [&](const GrowthCell& cell) {
    if (cell.seconds.size() < 2) return;
    ++cells;
    const double middle = std::log(median(cell.seconds));
    for (const double seconds : cell.seconds) all.push_back(std::log(seconds) - middle);
  });
  const double scale = std::sqrt(static_cast<double>(all.size()) / static_cast<double>(all.size() - cells));
  for (double& deviation : all) deviation *= scale;
  return all;
}

/// What runs differ by, as a share of their time, by how far the middle one of three resolutions lies off the line
/// through the others. That is a sum of the run's own deviation and about half of each of the other two.
double noise_of_resolutions(const GrowthRuns& runs) {
  double squares = 0, traced = 0;
  for (const GrowthSizeRuns& size : runs.sizes) {
    if (!size.is_traced()) continue;
    const double low = median(size.lowest().seconds), high = median(size.high.seconds);
    const double part = (size.middle.rays - size.lowest().rays) / (size.high.rays - size.lowest().rays);
    const double off = (median(size.middle.seconds) - (1 - part) * low - part * high) / high;
    squares += off * off / (1 + part * part + (1 - part) * (1 - part));
    ++traced;
  }
  return std::sqrt(squares / traced);
}

/// Every run drawn anew around its cell's median.
GrowthRuns drawn_again(const GrowthRuns& runs, std::span<const double> pool, double blur, Random& random) {
  GrowthRuns drawn = runs;
  for_each_cell(drawn, [&](GrowthCell& cell) {
    const double middle = median(cell.seconds);
    for (double& seconds : cell.seconds) {
      double deviation = blur * nearly_normal(random);
      if (!pool.empty()) deviation += pool[random.below(static_cast<std::uint32_t>(pool.size()))];
      seconds = middle * std::exp(deviation);
    }
  });
  return drawn;
}

/// The first of the sizes that span the top two octaves.
std::size_t top_begin(const std::vector<GrowthSizeRuns>& sizes) {
  std::size_t begin = sizes.size() - 1;
  while (begin > 0 && sizes[begin].size > sizes.back().size / 3.9) --begin;
  return begin;
}

/// Three slopes at one go: oblique, axis-aligned, build.
std::array<double, 3> slopes_of(const GrowthRuns& runs) {
  const std::vector<GrowthTimes> times = times_of(runs);
  std::vector<double> x, oblique, axis_aligned, top_x, build;
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (i >= top_begin(runs.sizes)) {
      top_x.push_back(std::log(runs.sizes[i].size));
      build.push_back(std::log(times[i].build));
    }
    if (!runs.sizes[i].is_traced()) continue;
    x.push_back(std::log(runs.sizes[i].size));
    oblique.push_back(std::log(times[i].oblique));
    axis_aligned.push_back(std::log(times[i].axis_aligned));
  }
  return {line_through(x, oblique).slope, line_through(x, axis_aligned).slope, line_through(top_x, build).slope};
}

}  // namespace

double median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

Line line_through(std::span<const double> x, std::span<const double> y) {
  const double mean_x = mean(x), mean_y = mean(y);
  double xx = 0, xy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
  }
  if (!(xx > 0)) throw std::invalid_argument("line_through: all points at one place");
  return {mean_y - xy / xx * mean_x, xy / xx};
}

std::vector<GrowthTimes> times_of(const GrowthRuns& runs) {
  const double start = median(runs.start.seconds);
  std::vector<GrowthTimes> all;
  for (const GrowthSizeRuns& size : runs.sizes) {
    GrowthTimes times;
    if (size.is_traced()) {
      const double rays[] = {size.lowest().rays, size.middle.rays, size.high.rays};
      const double seconds[] = {median(size.lowest().seconds), median(size.middle.seconds), median(size.high.seconds)};
      const Line line = line_through(rays, seconds);
      times.oblique = std::max(line.slope, kLeastGain / (rays[2] - rays[0]));
      times.axis_aligned =
          std::max(median(size.axis_aligned.seconds) - line.intercept, kLeastGain) / size.axis_aligned.rays;
    }
    times.build = std::max(median(size.fewest.seconds) - size.fewest.rays * times.oblique - start, kLeastBuild);
    all.push_back(times);
  }
  return all;
}

GrowthSlopes growth_slopes(const GrowthRuns& runs, double confidence, std::uint64_t seed) {
  const std::vector<double> pool = deviations(runs);
  const double blur = pool.empty() ? std::max(kLeastBlurUnrepeated, kDoubt * noise_of_resolutions(runs)) : kBlur;
  Random random(seed, "growth-slopes", 0);
  std::array<std::vector<double>, 3> replicates;
  for (int i = 0; i < kReplicates; ++i) {
    const std::array<double, 3> slopes = slopes_of(drawn_again(runs, pool, blur, random));
    for (std::size_t k = 0; k < slopes.size(); ++k) replicates[k].push_back(slopes[k]);
  }
  const std::array<double, 3> found = slopes_of(runs);
  const auto interval = [&](std::size_t k) -> GrowthSlope {
    std::ranges::sort(replicates[k]);
    const auto at = [&](double share) {
      return replicates[k][static_cast<std::size_t>(std::clamp(share * kReplicates, 0.0, kReplicates - 1.0))];
    };
    return {found[k], at((1 - confidence) / 2), at((1 + confidence) / 2)};
  };
  return {interval(0), interval(1), interval(2)};
}

GrowthDecision trace_decision(const GrowthSlope& slope, double margin) {
  if (slope.high < 0.5 - margin) return GrowthDecision::pass;
  if (slope.low > 0.6 + margin) return GrowthDecision::fail;
  return GrowthDecision::undecided;
}

GrowthDecision build_decision(const GrowthSlope& slope, double margin, bool last_word) {
  if (slope.low > 1.5 + margin) return GrowthDecision::fail;
  if (last_word || slope.high < 1.5 - margin || slope.slope < 1.2) return GrowthDecision::pass;
  return GrowthDecision::undecided;
}

}  // namespace plumb
