#include "conformance/judge/run_check_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "conformance/checks/run_checks.h"
#include "conformance/judge/build_submission.h"
#include "conformance/subject/kernel_subject.h"
#include "conformance/subject/probe_subject.h"
#include "renderer/image/staged_file.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

using Clock = std::chrono::steady_clock;

CheckResult without_answer(Verdict verdict, const std::string& cause, const std::string& summary,
                           const std::string& advice) {
  CheckResult result;
  result.verdict = verdict;
  result.cause = cause;
  result.summary = summary;
  result.advice = advice;
  return result;
}

/// `seconds` on the clock are left for the case, so no answer may take longer.
std::unique_ptr<Subject> open_door(const SuiteCase& suite_case, const Runner& runner,
                                   const Workspace::CaseFolder& folder, double seconds) {
  if (!runner.kernel.empty()) {
    KernelOptions options{.memory_bytes = suite_case.memory_mb << 20};
    options.seconds = std::min(options.seconds, seconds);
    return std::make_unique<KernelSubject>(folder.run / runner.kernel, options);
  }
  ProbeCommand command{
      .arguments = runner.probe, .folder = folder.run, .environment = environment(runner, folder.home)};
  command.limits.cpu_seconds = suite_case.cpu_seconds;
  command.limits.wall_seconds = std::min(command.limits.wall_seconds, seconds);
  command.limits.memory_bytes = suite_case.memory_mb << 20;
  command.limits.output_bytes = suite_case.output_mb << 20;
  return std::make_unique<ProbeSubject>(std::move(command));
}

/// All checks of the case, each result in turn. The time on the clock is looked at wherever a check reports its
/// progress.
CheckResult ask(const SuiteCase& suite_case, Subject& subject, double seconds) {
  const std::vector<const CheckKind*> checks = selected_checks(suite_case.filter);
  const Clock::time_point deadline =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  CheckOptions options{.intensity = suite_case.intensity, .seed = suite_case.seed};
  options.progress = [&](double) {
    if (Clock::now() > deadline)
      throw SubjectFailure(Verdict::timeout, "wall_time", fmt::format("more than {:g} s on the clock", seconds));
  };
  Subject* const doors[] = {&subject};
  std::vector<CheckResult> results;
  for (const CheckKind* check : checks) results.push_back(ask_check(*check, doors, options));
  return combined(checks, results);
}

}  // namespace

void run_check_case(const SuiteCase& suite_case, const Runner& runner, Workspace& workspace, double seconds_left,
                    const ResultFolder& results, CaseResult& result) {
  result.seed = suite_case.seed;
  if (runner.probe.empty() && runner.kernel.empty()) {
    result.check = without_answer(Verdict::fail, "build", "submission.toml names neither a probe nor a kernel",
                                  "say in [runner] how the checks are answered: probe = [...] or kernel = \"x.so\"");
    return;
  }
  const Workspace::CaseFolder folder = workspace.make_case_folder(suite_case, runner);
  try {
    const double seconds = std::min(suite_case.wall_seconds, seconds_left);
    const std::unique_ptr<Subject> door = open_door(suite_case, runner, folder, seconds);
    result.check = ask(suite_case, *door, seconds);
    if (const auto* probe = dynamic_cast<const ProbeSubject*>(door.get()))
      write_file_staged(results.case_folder(suite_case.id) / "log.txt", probe->failure_log());
    if (const auto* kernel = dynamic_cast<const KernelSubject*>(door.get()))
      write_file_staged(results.case_folder(suite_case.id) / "log.txt", kernel->log());
  } catch (const SubjectFailure& error) {
    result.check =
        without_answer(error.verdict(), error.cause(), error.what(), "start it by hand, and look at what it says");
  } catch (const InputError& error) {  // a library that cannot be loaded
    result.check =
        without_answer(Verdict::fail, "protocol", error.what(), "export plumb_kernel_v1 (docs/kernel-guide.md)");
  }
  if (!workspace.check_build())
    result.check = without_answer(Verdict::security, "build_changed",
                                  "the program changed its own build, which later cases would have run",
                                  "write only beside the scene or where the assignment says");
  workspace.remove_case_folder(folder);
}

}  // namespace plumb
