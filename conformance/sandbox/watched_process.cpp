#include "conformance/sandbox/watched_process.h"

#include <sys/prctl.h>
#include <sys/wait.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <stdexcept>
#include <utility>

#include "conformance/sandbox/end_processes.h"
#include "conformance/sandbox/process_memory.h"

namespace plumb {

namespace {

using Clock = WatchedProcess::Clock;
using std::chrono::milliseconds;

constexpr milliseconds kPeriod{10};
constexpr milliseconds kLongestPeriod{100};
constexpr milliseconds kFolderPeriod{100};
constexpr int kRestPerWork = 9;  // Watching takes at most a tenth of a core where it is slow.
constexpr std::int64_t kDrainAtOnce = 4 << 20;
constexpr std::int64_t kDrainAtEnd = 16 << 20;         // Far more than a pipe holds.
constexpr std::int64_t kOwnResidentGrowth = 16 << 20;  // By which we may grow between measuring and forking.

std::atomic<bool> run_is_going_on = false;

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

}  // namespace

RunScope::RunScope() {
  if (run_is_going_on.exchange(true)) {
    throw std::logic_error("run_process: a run is going on in this process already");
  }
  ::prctl(PR_GET_CHILD_SUBREAPER, &was_subreaper_);
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);
  // Ignored, children would vanish before they could be waited for.
  ::sigaction(SIGCHLD, nullptr, &child_signal_);
  const bool ignored = child_signal_.sa_handler == SIG_IGN || (child_signal_.sa_flags & SA_NOCLDWAIT) != 0;
  struct sigaction usual = {};
  usual.sa_handler = SIG_DFL;
  changed_signal_ = ignored && ::sigaction(SIGCHLD, &usual, nullptr) == 0;
}

RunScope::~RunScope() {
  if (changed_signal_) ::sigaction(SIGCHLD, &child_signal_, nullptr);
  ::prctl(PR_SET_CHILD_SUBREAPER, was_subreaper_);
  run_is_going_on = false;
}

WatchedProcess::WatchedProcess(const ProcessRequest& request)
    : limits_((check(request), request.limits)), log_(request.limits.log_bytes) {
  if (!request.writable_folder.empty()) folder_.emplace(request.writable_folder);
  own_resident_bytes_ = own_resident_bytes();
  start_ = Clock::now();
  next_look_ = start_;
  process_ = start_process(request);
  outcome_.active_limits = describe_limits(request);
}

WatchedProcess::~WatchedProcess() {
  try {
    end(StopReason::exited);
  } catch (const std::exception&) {  // It was ended while another error is on its way, or nobody asks how it ended.
  }
}

bool WatchedProcess::has_ended() const { return plumb::has_ended(process_.pid); }

void WatchedProcess::drain_log() {
  if (log_open_) log_open_ = drain(process_.log.get(), kDrainAtOnce, log_);
}

std::optional<StopReason> WatchedProcess::look() {
  const Clock::time_point begin = Clock::now();
  if (begin < next_look_) return {};
  const std::optional<StopReason> reason = passed_limit(begin);
  const Clock::time_point end = Clock::now();
  next_look_ = end + std::clamp<Clock::duration>(kRestPerWork * (end - begin), kPeriod, kLongestPeriod);
  return reason;
}

const RunOutcome& WatchedProcess::end(StopReason reason) {
  if (std::exchange(over_, true)) return outcome_;
  outcome_.reason = reason;
  if (!started()) {
    outcome_.reason = StopReason::cannot_start;
    outcome_.start_error = process_.error;
    return outcome_;
  }
  outcome_.wall_seconds = seconds_between(start_, Clock::now());
  settle(end_processes(tree_, process_.pid, meter_));
  return outcome_;
}

std::optional<StopReason> WatchedProcess::passed_limit(Clock::time_point now) {
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

bool WatchedProcess::memory_too_large(const std::vector<ProcessStat>& processes) {
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

bool WatchedProcess::folder_too_large() {
  if (!folder_) return false;
  const FolderSize size = folder_->measure();
  outcome_.output_bytes = std::max(outcome_.output_bytes, size.bytes);
  return size.bytes > limits_.output_bytes || !size.complete;
}

/// The kernel's record of the largest process, for one that came and went between two looks. It counts file
/// pages, so the most that were ever seen are taken off; and it begins with what we held ourselves at the fork,
/// so it says something only beyond that.
std::int64_t WatchedProcess::recorded_peak() const {
  const std::int64_t recorded = meter_.largest_resident_bytes();
  return recorded > own_resident_bytes_ + kOwnResidentGrowth ? recorded - largest_file_pages_ : 0;
}

/// The facts that are only certain when nothing runs any more.
void WatchedProcess::settle(int status) {
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

}  // namespace plumb
