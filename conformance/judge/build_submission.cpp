#include "conformance/judge/build_submission.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "conformance/judge/commands.h"
#include "conformance/sandbox/run_process.h"
#include "renderer/image/staged_file.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

/// Compilers are large; these bounds only keep a build from taking the machine down.
constexpr std::int64_t kBuildMemory = std::int64_t{4} << 30;
constexpr std::int64_t kBuildOutput = std::int64_t{1} << 30;

std::string search_path() {
  const char* path = std::getenv("PATH");
  return path ? path : "/usr/local/bin:/usr/bin:/bin";
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

std::string reason_text(const RunOutcome& run, double build_seconds) {
  switch (run.reason) {
    case StopReason::exited:
      return fmt::format("ended with exit status {}", run.exit_code);
    case StopReason::signalled:
      return fmt::format("was ended by signal {}", run.signal);
    case StopReason::cannot_start:
      return run.start_error;
    case StopReason::cpu_limit:
    case StopReason::wall_limit:
      return fmt::format("took longer than the {:g} s that a build may take", build_seconds);
    case StopReason::memory_limit:
      return "used more than 4 GiB of memory";
    case StopReason::output_limit:
      return "wrote more than 1 GiB";
    case StopReason::process_limit:
      return "started too many processes";
    case StopReason::interrupted:
      return "was interrupted";
  }
  throw std::logic_error("unknown stop reason");
}

CheckResult build_fault(const std::string& summary, const std::string& advice) {
  CheckResult result;
  result.verdict = Verdict::fail;
  result.cause = "build";
  result.summary = summary;
  result.advice = advice;
  return result;
}

bool is_installed(const std::string& program, const Runner& runner) {
  std::string folders = search_path();
  for (const auto& [name, value] : runner.env)
    if (name == "PATH") folders = value;
  std::istringstream path(folders);
  for (std::string folder; std::getline(path, folder, ':');)
    if (::access((fs::path(folder) / program).c_str(), X_OK) == 0) return true;
  return false;
}

}  // namespace

std::vector<std::string> environment(const Runner& runner, const fs::path& home) {
  std::vector<std::string> result{"PATH=" + search_path(), "HOME=" + home.string(), "TMPDIR=" + home.string(),
                                  "LANG=C.UTF-8"};
  for (const auto& [name, value] : runner.env) {
    std::erase_if(result, [&](const std::string& entry) { return entry.starts_with(name + "="); });
    result.push_back(name + "=" + value);
  }
  return result;
}

std::optional<CheckResult> build_submission(const BuildRequest& build) {
  const auto& [suite, runner, workspace, results, total_left] = build;
  std::string log;
  std::optional<CheckResult> fault;
  const double build_seconds = std::max(std::min(suite.build_seconds, total_left), 0.01);
  double seconds_left = build_seconds;
  const fs::path home = workspace.build().parent_path() / "build-home";
  fs::create_directories(home);
  for (const std::vector<std::string>& command : runner.build) {
    ProcessRequest request;
    try {
      request.arguments = build_command(command, workspace.build());
    } catch (const InputError& error) {
      fault =
          build_fault(error.what(), "check that all sources were handed in, in the folders that the assignment names");
      break;
    }
    request.folder = workspace.build();
    request.environment = environment(runner, home);
    request.writable_folder = workspace.build();
    request.limits = {.cpu_seconds = seconds_left * 2,
                      .wall_seconds = seconds_left,
                      .memory_bytes = kBuildMemory,
                      .output_bytes = kBuildOutput};
    const RunOutcome run = run_process(request);
    log += "$ " + joined(request.arguments) + "\n" + run.log;
    seconds_left = std::max(seconds_left - run.wall_seconds, 0.01);
    if (run.reason == StopReason::exited && run.exit_code == 0) continue;
    fault = build_fault(fmt::format("the build failed: '{}' {}", command.front(), reason_text(run, build_seconds)),
                        "read build/log.txt, and try the same command yourself");
    if (run.reason == StopReason::interrupted) fault->cause = "interrupted";
    break;
  }
  write_file_staged(results.build_folder() / "log.txt", log);
  return fault;
}

void require_programs(const Suite& suite) {
  if (!suite.has_runner) return;
  std::vector<std::vector<std::string>> commands = suite.runner.build;
  for (const auto& command : {suite.runner.render, suite.runner.probe})
    if (!command.empty()) commands.push_back(command);
  for (const std::vector<std::string>& command : commands) {
    if (command.front().find('/') != std::string::npos || is_installed(command.front(), suite.runner)) continue;
    throw InputError({suite.file.string()}, "'" + command.front() +
                                                "', which [runner] needs, is not installed; nothing was graded (a "
                                                "program of the submission is named by its path, './" +
                                                command.front() + "')");
  }
}

}  // namespace plumb
