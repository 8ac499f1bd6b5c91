#include "conformance/sandbox/run_process.h"

#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "conformance/sandbox/end_processes.h"
#include "conformance/sandbox/folder_size.h"
#include "conformance/sandbox/log_capture.h"
#include "conformance/sandbox/process_memory.h"
#include "conformance/sandbox/process_tree.h"
#include "conformance/sandbox/start_process.h"
#include "conformance/sandbox/usage_meter.h"

namespace plumb {

namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr milliseconds kPeriod{10};
constexpr milliseconds kLongestPeriod{100};
constexpr milliseconds kFolderPeriod{100};
constexpr int kRestPerWork = 9;  // Watching takes at most a tenth of a core where it is slow.
constexpr std::int64_t kDrainAtOnce = 4 << 20;
constexpr std::int64_t kDrainAtEnd = 16 << 20;         // Far more than a pipe holds.
constexpr std::int64_t kOwnResidentGrowth = 16 << 20;  // By which we may grow between measuring and forking.

double seconds_between(Clock::time_point from, Clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

void check(const ProcessRequest& request) {
  const RunLimits& limits = request.limits;
  const auto has_nul = [](const std::string& text) { return text.find('\0') != std::string::npos; };
  if (request.arguments.empty() || request.arguments.front().empty()) {
    throw std::invalid_argument("run_process: no program is named");
  }
  if (std::any_of(request.arguments.begin(), request.arguments.end(), has_nul) ||
      std::any_of(request.environment.begin(), request.environment.end(), has_nul)) {
    throw std::invalid_argument("run_process: an argument or environment variable holds a NUL byte");
  }
  // Written so that NaN is refused as well.
  if (!(limits.cpu_seconds > 0 && limits.wall_seconds > 0) || limits.memory_bytes <= 0 || limits.output_bytes < 0 ||
      limits.log_bytes < 0 || limits.processes_and_threads <= 0) {
    throw std::invalid_argument("run_process: a limit is not positive");
  }
}

std::vector<std::string> describe_limits(const ProcessRequest& request) {
  std::vector<std::string> active = {
      "cpu time: watched over all processes, RLIMIT_CPU for each",
      "wall time: watched",
      "memory: watched over all processes",
      "processes and threads: watched",
      "size of a file: RLIMIT_FSIZE",
  };
  if (!request.writable_folder.empty()) active.push_back("output: the folder's size and number of files watched");
  return active;
}

/// What this process is while a run goes on, put back after it.
class RunScope {
 public:
  RunScope() {
    if (running_.exchange(true)) throw std::logic_error("run_process: a run is going on in this process already");
    ::prctl(PR_GET_CHILD_SUBREAPER, &was_subreaper_);
    ::prctl(PR_SET_CHILD_SUBREAPER, 1);
    // Ignored, children would vanish before they could be waited for.
    ::sigaction(SIGCHLD, nullptr, &child_signal_);
    const bool ignored = child_signal_.sa_handler == SIG_IGN || (child_signal_.sa_flags & SA_NOCLDWAIT) != 0;
    struct sigaction usual = {};
    usual.sa_handler = SIG_DFL;
    changed_signal_ = ignored && ::sigaction(SIGCHLD, &usual, nullptr) == 0;
  }
  RunScope(const RunScope&) = delete;
  RunScope& operator=(const RunScope&) = delete;
  ~RunScope() {
    if (changed_signal_) ::sigaction(SIGCHLD, &child_signal_, nullptr);
    ::prctl(PR_SET_CHILD_SUBREAPER, was_subreaper_);
    running_ = false;
  }

 private:
  static inline std::atomic<bool> running_ = false;
  int was_subreaper_ = 0;
  struct sigaction child_signal_ = {};
  bool changed_signal_ = false;
};

/// One run from its start to its clean end.
class Run {
 public:
  explicit Run(const ProcessRequest& request) : limits_(request.limits), log_(request.limits.log_bytes) {
    if (!request.writable_folder.empty()) folder_.emplace(request.writable_folder);
    own_resident_bytes_ = own_resident_bytes();
    start_ = Clock::now();
    process_ = start_process(request);
    outcome_.active_limits = describe_limits(request);
  }

  RunOutcome finish() {
    if (process_.pid < 0) {
      outcome_.reason = StopReason::cannot_start;
      outcome_.start_error = process_.error;
      return std::move(outcome_);
    }
    try {
      outcome_.reason = watch();
    } catch (...) {
      end_processes(tree_, process_.pid, meter_);
      throw;
    }
    outcome_.wall_seconds = seconds_between(start_, Clock::now());
    settle(end_processes(tree_, process_.pid, meter_));
    return std::move(outcome_);
  }

 private:
  StopReason watch() {
    Clock::time_point next_look = start_;
    bool log_open = true;
    for (;;) {
      const auto wait = std::chrono::ceil<milliseconds>(std::max(next_look - Clock::now(), Clock::duration::zero()));
      pollfd events[] = {{process_.end.get(), POLLIN, 0}, {log_open ? process_.log.get() : -1, POLLIN, 0}};
      ::poll(events, 2, static_cast<int>(wait.count()));
      if (log_open) log_open = drain(process_.log.get(), kDrainAtOnce, log_);
      if (has_ended(process_.pid)) return StopReason::exited;
      const Clock::time_point begin = Clock::now();
      if (begin < next_look) continue;
      if (const std::optional<StopReason> reason = look(begin)) return *reason;
      const Clock::time_point end = Clock::now();
      next_look = end + std::clamp<Clock::duration>(kRestPerWork * (end - begin), kPeriod, kLongestPeriod);
    }
  }

  std::optional<StopReason> look(Clock::time_point now) {
    const std::vector<ProcessStat> processes = tree_.scan();
    meter_.sample(processes);
    reap_adopted(processes, process_.pid, meter_);
    if (interrupt_flag()) return StopReason::interrupted;
    if (now >= next_folder_look_) {
      if (folder_too_large()) return StopReason::output_limit;
      const Clock::time_point end = Clock::now();
      next_folder_look_ = end + std::max<Clock::duration>(kRestPerWork * (end - now), kFolderPeriod);
    }
    if (memory_too_large(processes)) return StopReason::memory_limit;
    std::int64_t threads = 0;
    for (const ProcessStat& process : processes) threads += process.threads;
    if (threads > limits_.processes_and_threads) return StopReason::process_limit;
    if (meter_.cpu_seconds() > limits_.cpu_seconds) return StopReason::cpu_limit;
    if (seconds_between(start_, Clock::now()) > limits_.wall_seconds) return StopReason::wall_limit;
    return {};
  }

  bool memory_too_large(const std::vector<ProcessStat>& processes) {
    std::int64_t sum = 0;
    for (const ProcessStat& process : processes) {
      const MemoryUse use = memory_of(process);
      sum += use.counted;
      largest_file_pages_ = std::max(largest_file_pages_, use.file_pages);
    }
    // The quick sum counts shared pages once for each process; only the slow one may cost a run.
    if (sum > limits_.memory_bytes) sum = memory_without_sharing(processes);
    outcome_.peak_memory_bytes = std::max(outcome_.peak_memory_bytes, sum);
    return sum > limits_.memory_bytes;
  }

  bool folder_too_large() {
    if (!folder_) return false;
    const FolderSize size = folder_->measure();
    outcome_.output_bytes = std::max(outcome_.output_bytes, size.bytes);
    return size.bytes > limits_.output_bytes || !size.complete;
  }

  /// The kernel's record of the largest process, for one that came and went between two looks. It counts file
  /// pages, so the most that were ever seen are taken off; and it begins with what we held ourselves at the fork,
  /// so it says something only beyond that.
  std::int64_t recorded_peak() const {
    const std::int64_t recorded = meter_.largest_resident_bytes();
    return recorded > own_resident_bytes_ + kOwnResidentGrowth ? recorded - largest_file_pages_ : 0;
  }

  /// The facts that are only certain when nothing runs any more.
  void settle(int status) {
    drain(process_.log.get(), kDrainAtEnd, log_);
    outcome_.log = log_.text();
    outcome_.log_bytes_dropped = log_.dropped();
    outcome_.cpu_seconds = meter_.cpu_seconds();
    outcome_.peak_memory_bytes = std::max(outcome_.peak_memory_bytes, recorded_peak());
    const bool too_much_output = folder_too_large();
    if (WIFEXITED(status)) outcome_.exit_code = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) outcome_.signal = WTERMSIG(status);
    if (outcome_.reason != StopReason::exited) return;
    if (outcome_.signal != 0) outcome_.reason = StopReason::signalled;
    if (too_much_output || outcome_.signal == SIGXFSZ) outcome_.reason = StopReason::output_limit;
    if (outcome_.peak_memory_bytes > limits_.memory_bytes) outcome_.reason = StopReason::memory_limit;
    if (outcome_.cpu_seconds > limits_.cpu_seconds) outcome_.reason = StopReason::cpu_limit;
  }

  RunLimits limits_;
  LogCapture log_;
  RunOutcome outcome_;
  RunScope scope_;
  ProcessTree tree_;  // Made before the process starts: what exists now is not of the run.
  UsageMeter meter_;
  std::optional<FolderWatch> folder_;
  std::int64_t own_resident_bytes_ = 0;
  std::int64_t largest_file_pages_ = 0;
  Clock::time_point start_;
  Clock::time_point next_folder_look_;
  StartedProcess process_;
};

}  // namespace

RunOutcome run_process(const ProcessRequest& request) {
  check(request);
  if (interrupt_flag()) {
    RunOutcome outcome;
    outcome.reason = StopReason::interrupted;
    return outcome;
  }
  Run run(request);
  return run.finish();
}

std::atomic<bool>& interrupt_flag() {
  static std::atomic<bool> flag = false;
  return flag;
}

}  // namespace plumb
