#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>

#include "conformance/judge/suite.h"
#include "conformance/results/result_set.h"

namespace plumb {

/// What to grade.
struct GradeRequest {
  /// A folder, as a student hands it in.
  std::filesystem::path submission;
  Suite suite;
  /// Where the results go.
  std::filesystem::path out;
  /// Only the cases whose id matches this GLOB, and their prerequisites; empty for all.
  std::string filter;
  /// Only the cases of this kind, and their prerequisites; empty for all.
  std::string kind;
  std::string plumb_version;
  /// Told what is being done, a short sentence.
  std::function<void(const std::string&)> progress = [](const std::string&) {};
};

/// Builds the submission once, runs and judges each case, and writes the result set. Cases run cheapest first, after
/// their prerequisites. What the submission does wrong is a verdict; nothing that it does ends the grading. An
/// interrupt (interrupt_flag) leaves the remaining cases skipped, pending, with the cause `interrupted`.
///
/// Throws InputError for what the caller got wrong: the submission is no folder, the results would lie inside it or it
/// inside them, a filter that matches nothing, a program of the suite's commands that is not installed.
ResultSet grade(const GradeRequest& request);

/// The places of the cases whose id matches a GLOB and whose kind is the given one (all for an empty text), and of
/// those that they require. Throws InputError if there is none.
std::set<std::size_t> selected_cases(const Suite& suite, const std::string& filter, const std::string& kind = "");

/// The places of the cases in the order that they are run in.
std::vector<std::size_t> run_order(const Suite& suite);

}  // namespace plumb
