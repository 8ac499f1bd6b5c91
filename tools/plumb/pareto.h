#pragma once

#include <cstdint>
#include <string>

namespace plumb {

struct ParetoArguments {
  /// The folder of CSV files and plots, made where it is not there.
  std::string out;
  /// Globs of kernels, parted by commas; empty for all. mt-double stands beside them in any case.
  std::string filter;
  double intensity = 1;
  std::uint64_t seed = 1;
};

/// `plumb check --pareto`: speed against error of the shipped kernels, as tables on standard output, and as CSV files
/// and plots in a folder. Throws InputError before anything is measured where gnuplot is missing, the folder cannot be
/// written, or no kernel matches. Returns 0, or 1 where a kernel failed as a program.
int run_pareto(const ParetoArguments& arguments);

}  // namespace plumb
