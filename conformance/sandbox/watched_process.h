#pragma once

#include <signal.h>

#include <chrono>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "conformance/sandbox/folder_size.h"
#include "conformance/sandbox/log_capture.h"
#include "conformance/sandbox/process_tree.h"
#include "conformance/sandbox/run_process.h"
#include "conformance/sandbox/start_process.h"
#include "conformance/sandbox/usage_meter.h"

namespace plumb {

/// What this process must be while it runs something that is not trusted, put back afterwards: it adopts orphaned
/// descendants and does not ignore SIGCHLD. One at a time in a process; a second one throws std::logic_error.
class RunScope {
 public:
  RunScope();
  RunScope(const RunScope&) = delete;
  RunScope& operator=(const RunScope&) = delete;
  ~RunScope();

 private:
  int was_subreaper_ = 0;
  struct sigaction child_signal_ = {};
  bool changed_signal_ = false;
};

/// A program that is not trusted, with all that it starts: it is looked at every now and then, held to its limits and
/// ended. What is said at run_process holds here too; who calls does the waiting.
class WatchedProcess {
 public:
  using Clock = std::chrono::steady_clock;

  /// Starts it. Throws as run_process does; a program that cannot be executed is no exception: see `started`.
  explicit WatchedProcess(const ProcessRequest& request);
  WatchedProcess(const WatchedProcess&) = delete;
  WatchedProcess& operator=(const WatchedProcess&) = delete;
  /// Ends it and all that it started, unless that was done.
  ~WatchedProcess();

  /// False if it could not be executed; `end` then says why.
  bool started() const { return process_.pid >= 0; }
  /// Whether the program itself has ended; others of its processes may be alive.
  bool has_ended() const;
  /// To poll: readable once the program has ended (-1 on an old kernel), and its log (-1 once that is closed).
  int end_descriptor() const { return process_.end.get(); }
  int log_descriptor() const { return log_open_ ? process_.log.get() : -1; }
  /// Takes in what stands in the log, about 4 MiB at most, so that an endless writer cannot hold the caller.
  void drain_log();
  /// Adds to the log what came by another way.
  void log(std::string_view text) { log_.append(text); }

  /// When `look` is due: often, but so that watching takes a tenth of a core at most.
  Clock::time_point next_look() const { return next_look_; }
  /// Looks at all processes, if that is due: the limit that they have passed, if any. The time on the clock counts from
  /// the start.
  std::optional<StopReason> look();

  /// Kills and reaps everything that is left, and says what happened, once and for all: a second call says the same.
  /// `reason` is what the caller saw; `exited` becomes what the facts say. Throws std::runtime_error where the
  /// processes cannot be ended within 10 seconds.
  const RunOutcome& end(StopReason reason);

 private:
  std::optional<StopReason> passed_limit(Clock::time_point now);
  bool memory_too_large(const std::vector<ProcessStat>& processes);
  bool folder_too_large();
  std::int64_t recorded_peak() const;
  void settle(int status);

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
  Clock::time_point next_look_;
  Clock::time_point next_folder_look_;
  StartedProcess process_;
  bool log_open_ = true;
  bool over_ = false;
};

}  // namespace plumb
