#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "conformance/families/random.h"
#include "conformance/growth/growth_gate.h"

namespace plumb {

/// A program as the gate sees one: times by a formula, with the noise of a shared machine. Seconds of processor time.
struct SimulatedProgram {
  double start = 0.01;
  std::function<double(double size)> build = [](double n) { return 2e-6 * n; };
  std::function<double(double size)> oblique_ray;
  std::function<double(double size)> axis_aligned_ray;
  /// What a just-in-time compiler takes in all, and after how many rays it is done.
  double warm_up = 0, warm_rays = 1;
  /// Each run takes up to so much more, and one in `outliers` half as much again (0: none does).
  double noise = 0.03;
  unsigned outliers = 0;
  double limit = 60;
};

/// `sizes` as in the settings.
inline GrowthAsk asked(const SimulatedProgram& program, std::vector<double> sizes, std::uint64_t seed) {
  return [program, sizes = std::move(sizes), random = Random(seed, "simulated", 0)](const GrowthQuestion& q) mutable {
    const double n = q.size ? sizes.at(*q.size) : 12;
    const double rays = static_cast<double>(q.width) * q.height;
    const double a_ray = q.view == GrowthView::oblique ? program.oblique_ray(n) : program.axis_aligned_ray(n);
    double seconds =
        program.start + program.build(n) + a_ray * rays + program.warm_up * (1 - std::exp(-rays / program.warm_rays));
    seconds *= 1 + program.noise * random.unit();
    if (program.outliers > 0 && random.one_in(program.outliers)) seconds *= 1.5;
    const bool over = seconds > program.limit;
    seconds = std::min(seconds, program.limit);
    return GrowthAnswer{.cpu_seconds = seconds, .wall_seconds = seconds + 0.02, .over_limit = over};
  };
}

}  // namespace plumb
