#pragma once

#include <cstdint>
#include <span>

#include "conformance/sandbox/process_tree.h"

namespace plumb {

/// Memory of one process, in bytes.
struct MemoryUse {
  /// Private pages, shared memory and what of them was swapped out. Pages of mapped files are the system's cache
  /// and do not count: a virtual machine's class archive or a mapped mesh is nobody's consumption.
  std::int64_t counted = 0;
  std::int64_t file_pages = 0;  ///< Resident pages of mapped files.
};

/// Reads /proc/PID/status; zeros for a process that has ended. A process whose main thread has ended shows
/// nothing there, so then its other threads are asked.
MemoryUse memory_of(const ProcessStat& process);

/// What the processes hold together, each shared page divided among those that share it (a process which forks
/// workers would else be charged with its pages once for each), and processes on the very same memory (vfork)
/// taken once. Walks their page tables, which takes milliseconds for each gigabyte. Where the kernel does not
/// tell, the value of `memory_of` stands in.
std::int64_t memory_without_sharing(std::span<const ProcessStat> processes);

/// What this process holds resident now, in bytes, file pages included. The kernel charges a child with it until
/// the child executes a program of its own, and keeps it in the child's ru_maxrss.
std::int64_t own_resident_bytes();

}  // namespace plumb
