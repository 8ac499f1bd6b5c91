#include "conformance/judge/run_case.h"

#include <fmt/format.h>

#include <algorithm>

#include "conformance/checks/image/image_check.h"
#include "conformance/judge/build_submission.h"
#include "conformance/judge/commands.h"
#include "conformance/judge/run_check_case.h"
#include "conformance/judge/stop_verdict.h"
#include "conformance/judge/suite_hash.h"
#include "conformance/sandbox/run_process.h"
#include "renderer/image/picture_header.h"
#include "renderer/image/staged_file.h"

namespace plumb {
namespace {

/// Whether the run left the build as it was; a build that is beyond repair makes every later case find the same.
bool build_changed(Workspace& workspace) {
  try {
    return !workspace.check_build();
  } catch (const LostBuild&) {
    return true;
  }
}

std::int64_t size_of_inputs(const SuiteCase& suite_case) {
  std::int64_t bytes = 0;
  for (const auto& input : suite_case.inputs) bytes += static_cast<std::int64_t>(std::filesystem::file_size(input));
  return bytes;
}

/// Only where the case's own limit was passed: what the suite's time for all cases cut short has no margin of its own.
std::optional<double> measured_margin(const SuiteCase& c, const RunOutcome& run, bool cut_by_budget) {
  if (cut_by_budget && run.reason == StopReason::wall_limit) return std::nullopt;
  switch (run.reason) {
    case StopReason::cpu_limit:
      return c.cpu_seconds - run.cpu_seconds;
    case StopReason::wall_limit:
      return c.wall_seconds - run.wall_seconds;
    case StopReason::memory_limit:
      return static_cast<double>((c.memory_mb << 20) - run.peak_memory_bytes);
    default:
      return std::nullopt;
  }
}

}  // namespace

void run_case(const SuiteCase& suite_case, const Runner& runner, Workspace& workspace, double seconds_left,
              const ResultFolder& results, CaseResult& result) {
  if (build_changed(workspace)) {  // by an earlier case, beyond repair
    result.check = stopped(Verdict::security, "build_changed", "an earlier case destroyed the build",
                           "write only beside the scene or where the assignment says");
    return;
  }
  if (suite_case.kind == "check") return run_check_case(suite_case, runner, workspace, seconds_left, results, result);
  if (runner.render.empty()) {
    result.check = stopped(Verdict::fail, "build", "submission.toml says nothing of how a picture is made",
                           "give render = [...] in its [runner]");
    return;
  }
  const Workspace::CaseFolder folder = workspace.make_case_folder(suite_case, runner);
  CasePaths paths = case_paths(runner, suite_case);
  const PictureHeader wanted = read_picture_header(suite_case.reference);
  paths.width = wanted.width, paths.height = wanted.height;
  std::filesystem::remove(folder.run / paths.output);  // an input of that name would be taken for the picture
  ProcessRequest request;
  request.arguments = render_command(runner, paths);
  request.folder = folder.run;
  request.environment = environment(runner, folder.home);
  request.writable_folder = folder.all;
  const bool budget_is_shorter = seconds_left < suite_case.wall_seconds;
  request.limits = {.cpu_seconds = suite_case.cpu_seconds,
                    .wall_seconds = std::min(suite_case.wall_seconds, seconds_left),
                    .memory_bytes = suite_case.memory_mb << 20,
                    .output_bytes = (suite_case.output_mb << 20) + size_of_inputs(suite_case)};
  const RunOutcome run = run_process(request);
  result.run = run;
  result.measured_margin = measured_margin(suite_case, run, budget_is_shorter);
  for (const auto& input : suite_case.inputs)
    result.input_hashes.emplace_back(input.filename().string(), file_hash(input));
  const std::filesystem::path evidence = results.case_folder(suite_case.id);
  write_file_staged(evidence / "log.txt", run.log);

  if (build_changed(workspace)) {
    result.check = stopped(Verdict::security, "build_changed",
                           "the program changed its own build, which later cases would have run",
                           "write only beside the scene or where the assignment says");
  } else if (const auto stop = verdict_of_stop(suite_case, run, budget_is_shorter)) {
    result.check = *stop;
  } else {
    const ImageCheck check = check_image({suite_case, run, folder.run, paths.output, evidence});
    result.check = check.result;
    result.by_variant = check.by_variant;
    result.hashes = check.hashes;
  }
  workspace.remove_case_folder(folder);
}

}  // namespace plumb
