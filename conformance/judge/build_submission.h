#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "conformance/judge/suite.h"
#include "conformance/judge/workspace.h"
#include "conformance/results/write_results.h"
#include "conformance/verdict.h"

namespace plumb {

/// A complete environment for a submission's commands: PATH as ours, HOME and TMPDIR in its own folder, a UTF-8 locale,
/// then the runner's own.
std::vector<std::string> environment(const Runner& runner, const std::filesystem::path& home);

struct BuildRequest {
  const Suite& suite;
  const Runner& runner;
  const Workspace& workspace;
  const ResultFolder& results;
  /// What the suite's total_seconds leaves.
  double seconds_left;
};

/// Runs the build commands in the workspace's copy, one after the other, within the suite's build_seconds in all (or
/// what is left, if that is less), and writes their output to build/log.txt of the results. Returns what went wrong
/// (cause `build`), or nothing. An interrupt ends it with the cause `interrupted`.
std::optional<CheckResult> build_submission(const BuildRequest& build);

/// Throws InputError if a program that the suite's own commands name without a path is not installed.
void require_programs(const Suite& suite);

}  // namespace plumb
