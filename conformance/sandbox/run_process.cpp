#include "conformance/sandbox/run_process.h"

#include <poll.h>

#include <algorithm>
#include <chrono>
#include <optional>

#include "conformance/sandbox/watched_process.h"

namespace plumb {

namespace {

StopReason watch(WatchedProcess& process) {
  using Clock = WatchedProcess::Clock;
  for (;;) {
    const auto wait = std::chrono::ceil<std::chrono::milliseconds>(
        std::max(process.next_look() - Clock::now(), Clock::duration::zero()));
    pollfd events[] = {{process.end_descriptor(), POLLIN, 0}, {process.log_descriptor(), POLLIN, 0}};
    ::poll(events, 2, static_cast<int>(wait.count()));
    process.drain_log();
    if (process.has_ended()) return StopReason::exited;
    if (const std::optional<StopReason> reason = process.look()) return *reason;
  }
}

}  // namespace

RunOutcome run_process(const ProcessRequest& request) {
  if (interrupt_flag()) {
    RunOutcome outcome;
    outcome.reason = StopReason::interrupted;
    return outcome;
  }
  WatchedProcess process(request);
  return process.end(process.started() ? watch(process) : StopReason::cannot_start);
}

std::atomic<bool>& interrupt_flag() {
  static std::atomic<bool> flag = false;
  return flag;
}

}  // namespace plumb
