#pragma once

#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

#include "conformance/sandbox/run_outcome.h"

namespace plumb {

/// A program to run and what it may use.
struct ProcessRequest {
  /// The program and its arguments; not empty. A program name without '/' is looked up in the PATH of
  /// `environment` (/bin:/usr/bin without one); any other is relative to `folder`. A file that is executable
  /// but of no known format is given to /bin/sh, as a shell would.
  std::vector<std::string> arguments;
  std::filesystem::path folder;          ///< Where the program starts.
  std::vector<std::string> environment;  ///< All of it, as NAME=VALUE; nothing is inherited.
  /// The folder whose total size is watched. Empty: none is, and only each single file is limited.
  std::filesystem::path writable_folder;
  RunLimits limits;
  /// An open file that becomes the program's standard input; it stays the caller's. -1: /dev/null.
  int input = -1;
  /// The same for its standard output. -1: the log.
  int output = -1;
  /// The same for its descriptor kLine. -1: that is closed, as all others are.
  int line = -1;
  static constexpr int kLine = 3;
};

/// Runs a program that is not trusted, to its end or to the first limit it passes, and kills everything that it
/// left behind: when this returns or throws anything but the error of the last paragraph, no process of the run
/// exists. The program has its own session, standard input from /dev/null, standard output and error in the
/// log, no other descriptor, default signal handling, umask 022, no core dumps and no way to gain privileges.
/// It is *not isolated*: it sees and may do what the user who runs us may.
///
/// One run at a time in a process; a second one throws std::logic_error. Meanwhile no other thread may start
/// processes (they would be taken for the submission's) or wait for children it did not start; children that
/// existed before, and what they start, are left alone. For the time of the run the calling process adopts
/// orphaned descendants (PR_SET_CHILD_SUBREAPER). The calling thread must live as long as the run.
///
/// Throws std::invalid_argument for a request that makes no sense, std::system_error where the system fails us,
/// and std::runtime_error where the processes of the run cannot be ended within 10 seconds.
RunOutcome run_process(const ProcessRequest& request);

/// Set (by a signal handler, say) to stop the run that is going on, and any later one before it starts, with
/// `StopReason::interrupted`. Nobody here clears it.
std::atomic<bool>& interrupt_flag();

}  // namespace plumb
