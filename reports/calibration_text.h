#pragma once

#include <span>
#include <string>

#include "conformance/results/growth_results.h"

namespace plumb {

/// The error rates of the growth gate as a table in Markdown: a line a program and question, how often it was decided
/// wrong or not at all, without and with background load, and the median time; below, false passes and false fails with
/// the rate that they stay below at 95 %.
std::string calibration_text(std::span<const CalibrationDecision> decisions);

/// The rate that `wrong` of `of` independent trials stays below at 95 %: the upper end of Clopper and Pearson's
/// one-sided interval [Clopper 1934]. 1 where nothing was tried.
double upper_rate(int wrong, int of);

}  // namespace plumb
