#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "conformance/results/pareto_results.h"

namespace plumb {

struct ParetoPlan {
  /// Of the shipped kernels; all for an empty one.
  std::vector<std::string> kernels;
  /// Multiplies the counts of rays, the pixels of pictures and, below 1, the time for speeds.
  double intensity = 1;
  std::uint64_t seed = 1;
  /// Scenes whose pictures are rendered.
  std::vector<std::filesystem::path> scenes;
  /// Told what is measured, and the share of it that is done.
  std::function<void(const std::string& what, double share)> progress = [](const std::string&, double) {};
};

/// At intensity 1: rays of each row of single surfaces, rays from inside of closed meshes for each aim, rays at each
/// mesh for each aim.
constexpr std::int64_t kParetoClassRays = 100'000;
constexpr std::int64_t kParetoEscapeRays = 280'000;
constexpr std::int64_t kParetoClosestRays = 20'000;

/// Measures speed against error: all kernels on the same rays, the three figures of triangles apart, then spheres, then
/// whole pictures. What a kernel does wrong as a program is a note of the results. All but times depends on the seed,
/// the counts and the kernels alone.
ParetoResults measure_pareto(const ParetoPlan& plan);

}  // namespace plumb
