#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "conformance/families/rounding.h"
#include "conformance/pareto/contender.h"
#include "conformance/results/pareto_results.h"

namespace plumb {

/// What speeds are measured on.
struct SpeedScene {
  std::string description;
  SubjectScene surfaces;
};

/// An icosphere of 20,480 triangles.
SpeedScene speed_mesh(const Rounding& rounded);
/// A thousand spheres of radius 0.02 to 0.08 in a cube of side 2.
SpeedScene speed_spheres(const Rounding& rounded);

/// From anywhere in a cube of side 8 to anywhere in one of side 2, both around zero, where the scenes are.
std::vector<Ray> speed_rays(std::uint64_t seed, std::size_t count, const Rounding& rounded);

struct SpeedPlan {
  /// Of all rays; a kernel that is too slow for them is asked the first ones alone.
  std::size_t rays = 1 << 18;
  /// CPU time that a kernel should be busy in a round, as far as the rays suffice.
  double seconds = 0.15;
  int rounds = 7;
};

/// Asks all contenders in turn, round after round, so that what else the machine does falls on all alike. Times are CPU
/// time, measured by the kernel's process. One figure a contender, without rounds where it failed or cannot be timed.
std::vector<SpeedFigure> speed_figures(std::span<Contender> contenders, SpeedScene (*scene)(const Rounding&),
                                       const SpeedPlan& plan, std::uint64_t seed,
                                       const std::function<void(double)>& progress);

/// The rounds of one contender, in million rays a second: median and spread. They are sorted.
SpeedFigure speed_figure(std::int64_t rays, std::vector<double> rounds);

}  // namespace plumb
