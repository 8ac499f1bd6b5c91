#pragma once

#include <filesystem>

#include "conformance/subject/checked_kernel.h"
#include "conformance/subject/kernel_client.h"

namespace plumb {

/// A kernel's shared library, in a child process that it may crash, hang or fill with garbage: the rest of a run is
/// unharmed. What it prints is in `log`. Used by one thread, the one that made it; the child ends with it.
class KernelSubject : public CheckedKernel {
 public:
  /// Throws InputError if the library cannot be loaded, has no entry, or says something of itself that cannot be, and
  /// SubjectFailure if it crashes or hangs where it should only be loaded.
  explicit KernelSubject(const std::filesystem::path& library, const KernelOptions& options = {});

  /// Standard output and error of the kernel so far, of all its processes: the beginning and the end of it.
  std::string log() const { return raw().log(); }
};

/// The same library in this very process, for tests and for what is trusted.
class LocalKernelSubject : public CheckedKernel {
 public:
  /// Throws InputError as KernelSubject does.
  explicit LocalKernelSubject(const std::filesystem::path& library);
};

}  // namespace plumb
