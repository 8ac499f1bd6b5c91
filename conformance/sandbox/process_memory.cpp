#include "conformance/sandbox/process_memory.h"

#include <linux/kcmp.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_set>

namespace plumb {

namespace {

/// The bytes of a line `key   1234 kB`, if it is that line.
std::optional<std::int64_t> kilobytes(std::string_view line, std::string_view key) {
  if (!line.starts_with(key)) return {};
  line.remove_prefix(key.size());
  line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
  std::int64_t value = 0;
  if (std::from_chars(line.data(), line.data() + line.size(), value).ec != std::errc()) return {};
  return value * 1024;
}

/// nullopt where the file has no memory lines: a zombie, a kernel thread, or nothing at all.
std::optional<MemoryUse> read_status(const std::string& path) {
  std::ifstream file(path);
  std::optional<MemoryUse> use;
  for (std::string line; std::getline(file, line);) {
    for (const char* key : {"RssAnon:", "RssShmem:", "VmSwap:"}) {
      if (const auto bytes = kilobytes(line, key)) {
        if (!use) use.emplace();
        use->counted += *bytes;
      }
    }
    if (const auto bytes = kilobytes(line, "RssFile:"); bytes && use) use->file_pages += *bytes;
  }
  return use;
}

/// nullopt where the kernel does not tell: no such file, no permission, or no memory any more.
std::optional<std::int64_t> proportional_share(pid_t pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/smaps_rollup");
  std::optional<std::int64_t> sum;
  for (std::string line; std::getline(file, line);) {
    for (const char* key : {"Pss_Anon:", "Pss_Shmem:", "SwapPss:"}) {
      if (const auto bytes = kilobytes(line, key)) sum = sum.value_or(0) + *bytes;
    }
  }
  return sum;
}

}  // namespace

MemoryUse memory_of(const ProcessStat& process) {
  const std::string folder = "/proc/" + std::to_string(process.id.pid);
  if (const auto use = read_status(folder + "/status")) return *use;
  if (process.threads < 2) return {};
  std::error_code gone;
  for (std::filesystem::directory_iterator task(folder + "/task", gone), end; !gone && task != end;
       task.increment(gone)) {
    if (const auto use = read_status(task->path().string() + "/status")) return *use;
  }
  return {};
}

std::int64_t memory_without_sharing(std::span<const ProcessStat> processes) {
  std::unordered_set<pid_t> present;
  std::int64_t sum = 0;
  for (const ProcessStat& process : processes) {
    present.insert(process.id.pid);
    const bool parent_is_here = present.contains(process.parent);
    if (parent_is_here && ::syscall(SYS_kcmp, process.id.pid, process.parent, KCMP_VM, 0, 0) == 0) continue;
    const std::optional<std::int64_t> share = proportional_share(process.id.pid);
    sum += share ? *share : memory_of(process).counted;
  }
  return sum;
}

std::int64_t own_resident_bytes() {
  std::ifstream file("/proc/self/statm");
  std::int64_t total = 0;
  std::int64_t resident = 0;
  file >> total >> resident;
  return resident * ::sysconf(_SC_PAGESIZE);
}

}  // namespace plumb
