#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "conformance/results/score_results.h"

namespace plumb {

struct SuiteScoreRequest {
  /// What build_suite made, with fingerprints.
  std::filesystem::path built;
  /// The programs with known mistakes, each by the id of its mistake, and the folder of the texts about them.
  std::filesystem::path mutants;
  std::filesystem::path known_mistakes;
  /// The same program without a mistake.
  std::filesystem::path tracer;
  /// Only the mutants whose id matches this GLOB; empty for all.
  std::string filter;
  /// Of checks and growth cases.
  std::uint64_t seed = 1;
  /// Of checks.
  double intensity = 1;
  std::string plumb_version;
  /// Told what is being done, and the share of all of it that is done.
  std::function<void(const std::string&, double)> progress = [](const std::string&, double) {};
};

/// Measures a suite by the known mistakes. Of each it says which image cases notice it, by the pictures that the suite
/// was built with; and what the checks and growth cases say that it names, which are run. All of these are asked of the
/// tracer without mistakes first, with the same seed: there each has to be right. A mutant that is said to equal an
/// accepted variant is graded by that variant alone.
///
/// An interrupt (interrupt_flag) leaves the rest undecided. Throws InputError if the suite cannot be read or was built
/// without fingerprints, the filter matches no mutant, or a program that has to be run is missing.
SuiteScore score_suite(const SuiteScoreRequest& request);

}  // namespace plumb
