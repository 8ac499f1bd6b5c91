#include "conformance/sandbox/process_tree.h"

#include <dirent.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <memory>
#include <system_error>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "conformance/sandbox/file_descriptor.h"

namespace plumb {

namespace {

/// Parents before children; each read again in that order. See ProcessTree::scan for why.
std::vector<ProcessStat> read_again_from_the_top(const std::vector<ProcessStat>& found) {
  std::unordered_set<pid_t> present;
  for (const ProcessStat& process : found) present.insert(process.id.pid);
  std::unordered_multimap<pid_t, std::size_t> children;
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (present.contains(found[i].parent)) {
      children.emplace(found[i].parent, i);
    } else {
      order.push_back(i);
    }
  }
  for (std::size_t next = 0; next < order.size(); ++next) {
    const auto [first, last] = children.equal_range(found[order[next]].id.pid);
    for (auto child = first; child != last; ++child) order.push_back(child->second);
  }
  std::vector<ProcessStat> result;
  result.reserve(order.size());
  for (const std::size_t i : order) {
    const std::optional<ProcessStat> now = read_process_stat(found[i].id.pid);
    if (now && now->id == found[i].id) result.push_back(*now);
  }
  return result;
}

}  // namespace

std::optional<ProcessStat> parse_process_stat(std::string_view text) {
  const std::size_t name_begin = text.find('(');
  const std::size_t name_end = text.rfind(')');
  if (name_begin == std::string_view::npos || name_end == std::string_view::npos || name_end < name_begin) return {};
  ProcessStat stat;
  const char* const first = text.data();
  if (std::from_chars(first, first + name_begin, stat.id.pid).ec != std::errc()) return {};
  if (text.size() < name_end + 4) return {};
  stat.state = text[name_end + 2];
  // The fields after the state, numbered as in proc(5) from 4 on.
  std::array<std::int64_t, 19> field = {};
  const char* at = first + name_end + 3;
  const char* const end = first + text.size();
  for (std::int64_t& value : field) {
    while (at != end && *at == ' ') ++at;
    const auto [next, error] = std::from_chars(at, end, value);
    if (error != std::errc()) return {};
    at = next;
  }
  stat.parent = static_cast<pid_t>(field[4 - 4]);
  stat.user = field[14 - 4];
  stat.system = field[15 - 4];
  stat.children_user = field[16 - 4];
  stat.children_system = field[17 - 4];
  stat.threads = field[20 - 4];
  stat.id.start = static_cast<std::uint64_t>(field[22 - 4]);
  return stat;
}

std::optional<ProcessStat> read_process_stat(pid_t pid) {
  std::array<char, 32> path;
  std::snprintf(path.data(), path.size(), "/proc/%d/stat", static_cast<int>(pid));
  const FileDescriptor file(::open(path.data(), O_RDONLY | O_CLOEXEC));
  if (!file.valid()) return {};
  std::array<char, 1024> text;
  const ssize_t size = ::read(file.get(), text.data(), text.size());
  if (size <= 0) return {};
  return parse_process_stat({text.data(), static_cast<std::size_t>(size)});
}

bool send_signal(const ProcessId& id, int signal) {
  const FileDescriptor process(static_cast<int>(::syscall(SYS_pidfd_open, id.pid, 0)));
  // Looked at after it is held: the number cannot pass to another process between the look and the signal.
  const std::optional<ProcessStat> now = read_process_stat(id.pid);
  if (!now || now->id != id) return false;
  if (!process.valid()) return ::kill(id.pid, signal) == 0;  // A kernel before 5.3, or no descriptor left.
  return ::syscall(SYS_pidfd_send_signal, process.get(), signal, nullptr, 0) == 0;
}

/// What one walk over /proc has found so far. The numbers are of processes read in this walk, so that a parent's
/// number cannot be that of a process long gone.
struct ProcessTree::Pass {
  int signal;
  std::vector<ProcessStat> found;
  std::vector<ProcessStat> unknown;
  std::unordered_set<pid_t> ours;
  std::unordered_set<pid_t> others;
};

ProcessTree::ProcessTree() : self_(::getpid()) {
  for (const ProcessStat& process : scan()) others_.insert(process.id);
  ours_.clear();
}

void ProcessTree::classify(const ProcessStat& process, Pass& pass) {
  const pid_t pid = process.id.pid;
  if (others_.contains(process.id) || (!ours_.contains(process.id) && pass.others.contains(process.parent))) {
    others_.insert(process.id);
    pass.others.insert(pid);
  } else if (ours_.contains(process.id) || process.parent == self_ || pass.ours.contains(process.parent)) {
    ours_.insert(process.id);
    pass.ours.insert(pid);
    pass.found.push_back(process);
    if (pass.signal != 0) send_signal(process.id, pass.signal);
  } else {
    pass.unknown.push_back(process);
  }
}

std::vector<ProcessStat> ProcessTree::scan(int signal) {
  Pass pass{signal, {}, {}, {}, {}};
  const std::unique_ptr<DIR, int (*)(DIR*)> proc(::opendir("/proc"), &::closedir);
  if (!proc) throw std::system_error(errno, std::generic_category(), "cannot list /proc");
  while (const dirent* entry = ::readdir(proc.get())) {
    if (entry->d_name[0] < '1' || entry->d_name[0] > '9') continue;
    pid_t pid = 0;
    const std::string_view name = entry->d_name;
    if (std::from_chars(name.data(), name.data() + name.size(), pid).ec != std::errc()) continue;
    if (const std::optional<ProcessStat> stat = read_process_stat(pid)) classify(*stat, pass);
  }

  // Numbers start again at the top of their range, so a child may stand before its parent.
  for (std::size_t before = pass.unknown.size() + 1; pass.unknown.size() < before;) {
    before = pass.unknown.size();
    const std::vector<ProcessStat> unknown = std::exchange(pass.unknown, {});
    for (const ProcessStat& process : unknown) classify(process, pass);
  }

  // One whose parent ended while we read hangs on nothing for a moment; it is known by itself.
  for (auto id = ours_.begin(); id != ours_.end();) {
    if (!pass.ours.contains(id->pid)) {
      const std::optional<ProcessStat> now = read_process_stat(id->pid);
      if (!now || now->id != *id) {
        id = ours_.erase(id);
        continue;
      }
      classify(*now, pass);
    }
    ++id;
  }
  return read_again_from_the_top(pass.found);
}

}  // namespace plumb
