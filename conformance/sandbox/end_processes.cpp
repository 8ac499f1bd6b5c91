#include "conformance/sandbox/end_processes.h"

#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

namespace plumb {

namespace {

constexpr std::chrono::seconds kPatience{10};
constexpr int kFreezeRounds = 5;
constexpr int kEmptyLooks = 2;

/// Stops them all first, so that none forks or waits while the others die. A stopped one stays in the list, so
/// the list grows only while there is a new one.
void freeze(ProcessTree& tree, std::size_t known) {
  for (int round = 0; round < kFreezeRounds; ++round) {
    const std::size_t found = tree.scan(SIGSTOP).size();
    if (found <= known) return;
    known = found;
  }
}

[[noreturn]] void cannot_end(const std::vector<ProcessStat>& left) {
  std::string text = "cannot end " + std::to_string(left.size()) + " processes of a submission";
  if (!left.empty()) text += ", such as " + std::to_string(left[0].id.pid) + " in state " + left[0].state;
  throw std::runtime_error(text);
}

}  // namespace

bool has_ended(pid_t pid) {
  siginfo_t info = {};
  int result;
  while ((result = ::waitid(P_PID, static_cast<id_t>(pid), &info, WEXITED | WNOHANG | WNOWAIT)) != 0 &&
         errno == EINTR) {
  }
  if (result != 0) throw std::system_error(errno, std::generic_category(), "cannot wait for a process of a run");
  return info.si_pid == pid;
}

void reap_adopted(std::span<const ProcessStat> processes, pid_t leader, UsageMeter& meter) {
  for (const ProcessStat& process : processes) {
    if (process.id.pid == leader || process.parent != ::getpid() || process.state != 'Z') continue;
    rusage usage;
    if (::wait4(process.id.pid, nullptr, WNOHANG | __WALL, &usage) == process.id.pid) meter.add_reaped(usage);
  }
}

int end_processes(ProcessTree& tree, pid_t leader, UsageMeter& meter) {
  const auto give_up = std::chrono::steady_clock::now() + kPatience;
  std::chrono::milliseconds pause{1};
  for (int empty_looks = 0; empty_looks < kEmptyLooks;) {
    ::kill(-leader, SIGKILL);
    std::vector<ProcessStat> left = tree.scan();
    if (left.size() > 1) freeze(tree, left.size());
    left = tree.scan(SIGKILL);
    meter.sample(left);
    reap_adopted(left, leader, meter);
    const bool leader_ended = has_ended(leader);
    std::erase_if(left, [&](const ProcessStat& process) { return leader_ended && process.id.pid == leader; });
    if (leader_ended && left.empty()) {
      // One that was handed on between parents during one look is found by the next.
      ++empty_looks;
      continue;
    }
    empty_looks = 0;
    if (std::chrono::steady_clock::now() > give_up) cannot_end(left);
    std::this_thread::sleep_for(pause);
    pause = std::min(pause * 2, std::chrono::milliseconds{20});
  }

  int status = 0;
  rusage usage;
  while (::wait4(leader, &status, 0, &usage) < 0) {
    if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "cannot wait for a process of a run");
  }
  meter.add_reaped(usage);
  meter.sample({});
  meter.sample({});  // What vanished is settled one look later.
  return status;
}

}  // namespace plumb
