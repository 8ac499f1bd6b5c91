#pragma once

#include <sys/types.h>

#include <string>

#include "conformance/sandbox/file_descriptor.h"
#include "conformance/sandbox/run_process.h"

namespace plumb {

/// A program that was started, or not.
struct StartedProcess {
  pid_t pid = -1;      ///< Also its process group and session; it must be waited for. -1 if it did not start.
  FileDescriptor end;  ///< Readable once it has ended (a pidfd); may be none on an old kernel.
  FileDescriptor log;  ///< Standard output and error together; reading never waits.
  std::string error;   ///< Why it did not start; a process that failed to is already waited for.
};

/// Forks and executes as `run_process` says, and returns when the program runs or is known not to. Throws
/// std::system_error where that is no fault of the request.
StartedProcess start_process(const ProcessRequest& request);

}  // namespace plumb
