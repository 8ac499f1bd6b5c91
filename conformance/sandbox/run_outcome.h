#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace plumb {

/// Why a run is over. A fact, not a judgement: what it means for points is decided elsewhere.
enum class StopReason {
  exited,         ///< The program ended by itself, whatever its exit code.
  signalled,      ///< A signal ended it which no limit of ours sent.
  cpu_limit,      ///< It and its descendants used more processor time than allowed.
  wall_limit,     ///< It was still there when the time on the clock was over.
  memory_limit,   ///< It and its descendants held more memory than allowed.
  output_limit,   ///< Its folder grew past the bytes or files allowed, or cannot be measured any more.
  cannot_start,   ///< It could not be executed; `RunOutcome::start_error` says why.
  interrupted,    ///< `interrupt_flag()` was set.
  process_limit,  ///< It and its descendants were more processes and threads than allowed.
};

/// The name of a reason as it is written above, for files and messages.
const char* to_string(StopReason reason);

/// What a run may use. All values are totals over the program and all of its descendants.
struct RunLimits {
  double cpu_seconds = 10;                     ///< Processor time, user and system; > 0.
  double wall_seconds = 60;                    ///< Time on the clock; > 0.
  std::int64_t memory_bytes = 1LL << 30;       ///< Private and shared memory, without mapped files; > 0.
  std::int64_t output_bytes = 64LL << 20;      ///< Bytes of all files below the writable folder; >= 0.
  std::int64_t log_bytes = 1LL << 20;          ///< Bytes of standard output and error that are kept; >= 0.
  std::int64_t processes_and_threads = 4'096;  ///< How many may exist at a time; > 0.
};

/// What happened in one run.
struct RunOutcome {
  StopReason reason = StopReason::exited;
  int exit_code = -1;  ///< What the program returned; -1 if it did not end by itself.
  int signal = 0;      ///< The signal that ended it (SIGKILL where a limit was passed); 0 if none.
  /// User and system time of the program and all its descendants. Where the reason is not `cpu_limit`, it is
  /// within the limit.
  double cpu_seconds = 0;
  /// From the start until the program was seen to have ended. May pass the limit by the watcher's delay.
  double wall_seconds = 0;
  /// The largest total seen (see `process_memory.h` for what is counted and where it is only an estimate).
  std::int64_t peak_memory_bytes = 0;
  /// The largest total size of files seen below the writable folder, those of before the run included.
  std::int64_t output_bytes = 0;
  std::int64_t log_bytes_dropped = 0;  ///< Bytes of output that `log` leaves out.
  /// Standard output and error as they were mixed, raw bytes of the subject: the first and the last half of
  /// the cap, and between them a line that says how many bytes were dropped.
  std::string log;
  std::vector<std::string> active_limits;  ///< The limits in force and how each is enforced, a sentence each.
  std::string start_error;                 ///< For `cannot_start`: `cannot run ./tracer: No such file or directory`.
};

}  // namespace plumb
