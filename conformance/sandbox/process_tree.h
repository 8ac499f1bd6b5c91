#pragma once

#include <sys/types.h>

#include <compare>
#include <cstdint>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

namespace plumb {

/// One process for ever: numbers are used again, but not with the same start.
struct ProcessId {
  pid_t pid = 0;
  std::uint64_t start = 0;  ///< Clock ticks after the boot.
  auto operator<=>(const ProcessId&) const = default;
};

/// One line of /proc/PID/stat. Times are clock ticks of the whole process, all its threads, rounded down.
struct ProcessStat {
  ProcessId id;
  pid_t parent = 0;
  char state = '?';                  ///< 'Z' is also shown while threads outlive the main one.
  std::int64_t user = 0;             ///< Of its own.
  std::int64_t system = 0;           ///< Of its own.
  std::int64_t children_user = 0;    ///< Of ended descendants which were waited for.
  std::int64_t children_system = 0;  ///< Of ended descendants which were waited for.
  std::int64_t threads = 0;
};

/// Understands the text of /proc/PID/stat, whose name field may hold any characters; nullopt if it is not one.
std::optional<ProcessStat> parse_process_stat(std::string_view text);

/// Reads /proc/PID/stat; nullopt if there is no such process. A zombie still has one.
std::optional<ProcessStat> read_process_stat(pid_t pid);

/// Sends `signal` to that very process and to no other that has got its number since. False if it is gone.
bool send_signal(const ProcessId& id, int signal);

/// Finds the descendants of this process which were not there when the tree was made, nor come from one that
/// was. For nothing to be lost, this process must adopt orphans (PR_SET_CHILD_SUBREAPER); an adopted orphan
/// counts as new unless it was seen below an older process before.
class ProcessTree {
 public:
  /// Notes the descendants that exist now, to leave them alone.
  ProcessTree();

  /// The new descendants, zombies included, each parent before its children. As a parent is read before its
  /// children, a process that ends meanwhile may be missing from the sum of times, but is never in it twice.
  /// With `signal` != 0, each one is sent it the moment that it is found, so that one which forks and exits
  /// faster than a list can be made is caught nevertheless.
  std::vector<ProcessStat> scan(int signal = 0);

 private:
  struct Pass;
  void classify(const ProcessStat& process, Pass& pass);

  pid_t self_;
  std::set<ProcessId> others_;  // Older descendants and what they started.
  std::set<ProcessId> ours_;    // Once found always ours, whatever its parent is by now.
};

}  // namespace plumb
