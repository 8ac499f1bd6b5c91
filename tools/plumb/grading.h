#pragma once

#include <string>

#include "conformance/judge/grade.h"

namespace plumb {

constexpr int kInterrupted = 130;

/// From now on, SIGINT and SIGTERM end what is run, not this program (interrupt_flag).
void stop_on_signals();

/// Grades on the command line: says what will be run, shows progress on a terminal, prints the table and what the
/// growth gates measured, and draws their plots. Returns the exit status.
int grade_and_report(GradeRequest request);

/// `plumb-results/NAME`, for a submission that is the folder NAME.
std::filesystem::path default_results(const std::filesystem::path& submission);

}  // namespace plumb
