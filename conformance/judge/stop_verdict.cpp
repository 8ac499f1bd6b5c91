#include "conformance/judge/stop_verdict.h"

#include <fmt/format.h>

#include <stdexcept>

namespace plumb {

CheckResult stopped(Verdict verdict, const std::string& cause, const std::string& summary, const std::string& advice) {
  CheckResult result;
  result.verdict = verdict;
  result.cause = cause;
  result.summary = summary;
  result.advice = advice;
  return result;
}

std::optional<CheckResult> verdict_of_stop(const SuiteCase& c, const RunOutcome& run, bool cut_by_budget) {
  switch (run.reason) {
    case StopReason::exited:
    case StopReason::cannot_start:
      return std::nullopt;
    case StopReason::signalled:
      return stopped(Verdict::crash, "signal", fmt::format("the program was ended by signal {}", run.signal),
                     "read log.txt, and run it in a debugger");
    case StopReason::cpu_limit:
      return stopped(Verdict::timeout, "cpu_time", fmt::format("more than {:g} s of processor time", c.cpu_seconds),
                     "look for an endless loop, or a search that tries every surface for each ray");
    case StopReason::wall_limit:
      if (cut_by_budget)
        return stopped(Verdict::timeout, "budget_spent", "the time for all cases together was spent",
                       "make the slow cases faster");
      return stopped(Verdict::timeout, "wall_time", fmt::format("more than {:g} s on the clock", c.wall_seconds),
                     "the program waits for something: input, a window, a lock");
    case StopReason::memory_limit:
      return stopped(Verdict::memory_limit, "memory", fmt::format("more than {} MiB of memory", c.memory_mb),
                     "look for data that grows with every ray");
    case StopReason::output_limit:
      return stopped(Verdict::output_limit, "output_size",
                     fmt::format("more than {} MiB (or 100,000 files) written", c.output_mb), "write only the picture");
    case StopReason::process_limit:
      return stopped(Verdict::memory_limit, "processes", "too many processes and threads",
                     "start no more threads than there are processors");
    case StopReason::interrupted:
      return stopped(Verdict::skipped, "interrupted", "grading was interrupted", "grade again");
  }
  throw std::logic_error("unknown stop reason");
}

}  // namespace plumb
