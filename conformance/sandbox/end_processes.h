#pragma once

#include <sys/types.h>

#include <span>

#include "conformance/sandbox/process_tree.h"
#include "conformance/sandbox/usage_meter.h"

namespace plumb {

/// Whether the direct child `pid` has ended, without waiting for it: it stays a zombie, and its number its own.
bool has_ended(pid_t pid);

/// Waits for those of `processes` that were orphaned, adopted by this process and have ended; each one's usage
/// goes to `meter`. The zombie `leader` is left.
void reap_adopted(std::span<const ProcessStat> processes, pid_t leader, UsageMeter& meter);

/// Kills and reaps all processes of `tree`, whatever they do about it (stop, ignore signals, fork all the time,
/// leave their session), the leader last: until then nobody else can get its number, so its group can be killed
/// in one stroke. All usage goes to `meter`. Returns the wait status of the leader, a direct child that nobody
/// has waited for yet. Throws std::runtime_error if something is still alive after 10 seconds.
int end_processes(ProcessTree& tree, pid_t leader, UsageMeter& meter);

}  // namespace plumb
