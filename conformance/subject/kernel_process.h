#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "conformance/sandbox/file_descriptor.h"
#include "conformance/sandbox/log_capture.h"
#include "conformance/sandbox/start_process.h"
#include "conformance/subject/kernel_message.h"
#include "conformance/subject/subject.h"

namespace plumb {

/// A message that was received.
struct KernelMessage {
  KernelWord word;
  std::vector<std::byte> bytes;
};

/// A child process that hosts a kernel, and the line to it. The process, and its process group, end with this object
/// and with the thread that made it.
class KernelProcess {
 public:
  /// Starts `host LIBRARY` with the line as its standard input; its output goes to `log`, which must outlive this.
  /// Throws std::runtime_error if the host cannot be started.
  KernelProcess(const std::filesystem::path& host, const std::filesystem::path& library, std::int64_t memory_bytes,
                LogCapture& log);
  ~KernelProcess();
  KernelProcess(const KernelProcess&) = delete;
  KernelProcess& operator=(const KernelProcess&) = delete;

  /// Sends a message (an empty one: nothing), and waits for one of at most `most_bytes`. Throws SubjectFailure where
  /// none comes: `timeout` after so many seconds on the clock, `memory_limit`, `crash` if a signal or an exit status
  /// ended the process, and fail with `protocol` for an end without one or for what is no message. Then the process is
  /// no more.
  KernelMessage exchange(std::span<const std::byte> message, double seconds, std::uint64_t most_bytes);

 private:
  class Exchange;
  [[noreturn]] void fail(Verdict verdict, const char* cause, const std::string& sentence);
  [[noreturn]] void fail_as_ended();
  void check_memory();
  int end();

  LogCapture& log_;
  std::int64_t memory_bytes_;
  FileDescriptor line_;
  StartedProcess process_;
};

}  // namespace plumb
