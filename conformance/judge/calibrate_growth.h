#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "conformance/judge/suite.h"
#include "conformance/results/growth_results.h"

namespace plumb {

/// Programs of known growth, to measure the gate's own error rates with.
struct CalibrationRequest {
  /// A folder of submissions, and `expected.toml`: a table a submission, and in it what each case of the suite must say
  /// (`mesh-trace = "fail"`). Only cases that stand there are asked.
  std::filesystem::path subjects;
  /// With cases of kind growth.
  Suite suite;
  /// A line of JSON a decision. What stands in it already counts, so that an interrupted calibration goes on.
  std::filesystem::path record;
  /// How many gates are run in all, those of the record included: as often each, half of them with background load.
  int gates = 0;
  std::string plumb_version;
  /// Told what is done next, and how many gates are done.
  std::function<void(const std::string& what, int done)> progress;
};

/// Runs the gates and appends to the record; returns all decisions of the record. An interrupt (interrupt_flag) ends it
/// after the gate that is running, which does not count. Throws InputError for an expectation that fits no case, a
/// submission that is not there, a record that is none.
std::vector<CalibrationDecision> calibrate_growth(const CalibrationRequest& request);

}  // namespace plumb
