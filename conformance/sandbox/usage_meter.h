#pragma once

#include <sys/resource.h>

#include <cstdint>
#include <map>
#include <span>

#include "conformance/sandbox/process_tree.h"

namespace plumb {

/// Adds up the processor time of a changing set of processes, counting none of it twice.
///
/// Time stands in three places: with a living process, with a process that has waited for it (the times "of
/// children", which travel upwards with each wait), and with us for what we wait for ourselves. A process that
/// ignores SIGCHLD lets its children's time vanish; what was last seen of such a child is kept here. So the sum
/// is never too large, and too small only by what a child ignored in that way used since it was last seen, and
/// by the rounding of living processes (10 ms each).
class UsageMeter {
 public:
  UsageMeter();

  /// Takes in one look at the processes alive (zombies not yet waited for included), each parent read before its
  /// children. All that was waited for by this process since the last look must have been given to add_reaped.
  void sample(std::span<const ProcessStat> alive);
  /// Takes in what wait4 told about a process that this process has waited for.
  void add_reaped(const rusage& usage);

  /// User and system time of all processes seen so far. Never falls.
  double cpu_seconds() const;
  /// The largest resident size (file pages included) that the kernel recorded for any one process reaped, or for
  /// one that such a process has waited for; 0 if none.
  std::int64_t largest_resident_bytes() const { return largest_resident_bytes_; }

 private:
  struct Times {  // Microseconds.
    std::int64_t user = 0;
    std::int64_t system = 0;
    Times& operator+=(const Times& other);
    Times& operator-=(const Times& other);
    std::int64_t sum() const { return user + system; }
  };
  struct Seen {
    Times total;
    Times children;
  };
  Times from_ticks(std::int64_t user, std::int64_t system) const;

  std::int64_t microseconds_per_tick_;
  std::map<ProcessId, Seen> seen_;  // At the last look.
  Times reaped_;
  Times reaped_since_look_;
  Times lost_;
  Times vanished_;  // What the processes had that were gone at the last look,
  Times credited_;  // and what had turned up in the times of children then.
  std::int64_t most_ = 0;
  std::int64_t largest_resident_bytes_ = 0;
};

}  // namespace plumb
