#include "conformance/sandbox/usage_meter.h"

#include <unistd.h>

#include <algorithm>
#include <utility>

namespace plumb {

UsageMeter::Times& UsageMeter::Times::operator+=(const Times& other) {
  user += other.user;
  system += other.system;
  return *this;
}

UsageMeter::Times& UsageMeter::Times::operator-=(const Times& other) {
  user -= other.user;
  system -= other.system;
  return *this;
}

UsageMeter::UsageMeter() : microseconds_per_tick_(1'000'000 / ::sysconf(_SC_CLK_TCK)) {}

UsageMeter::Times UsageMeter::from_ticks(std::int64_t user, std::int64_t system) const {
  return {user * microseconds_per_tick_, system * microseconds_per_tick_};
}

void UsageMeter::sample(std::span<const ProcessStat> alive) {
  std::map<ProcessId, Seen> now;
  Times living;
  Times credited = std::exchange(reaped_since_look_, {});
  for (const ProcessStat& process : alive) {
    Seen seen;
    seen.children = from_ticks(process.children_user, process.children_system);
    seen.total = from_ticks(process.user, process.system);
    seen.total += seen.children;
    living += seen.total;
    credited += seen.children;
    if (const auto before = seen_.find(process.id); before != seen_.end()) credited -= before->second.children;
    now.emplace(process.id, seen);
  }
  Times vanished;
  for (const auto& [id, seen] : seen_) {
    if (!now.contains(id)) vanished += seen.total;
  }

  // What vanished before the last look was credited to some parent before the last look or, if that parent had
  // been read already, before this one. Both sides are whole ticks, and floor(a + x) - floor(a) >= floor(x), so
  // rounding alone never makes a difference positive.
  const auto deficit = [](std::int64_t gone, std::int64_t got) { return std::max<std::int64_t>(gone - got, 0); };
  lost_ += {deficit(vanished_.user, credited_.user + credited.user),
            deficit(vanished_.system, credited_.system + credited.system)};
  vanished_ = vanished;
  credited_ = credited;
  seen_ = std::move(now);
  most_ = std::max(most_, living.sum() + reaped_.sum() + lost_.sum());
}

void UsageMeter::add_reaped(const rusage& usage) {
  const auto microseconds = [](const timeval& t) { return std::int64_t{t.tv_sec} * 1'000'000 + t.tv_usec; };
  const Times times{microseconds(usage.ru_utime), microseconds(usage.ru_stime)};
  reaped_ += times;
  reaped_since_look_ += times;
  largest_resident_bytes_ = std::max<std::int64_t>(largest_resident_bytes_, std::int64_t{usage.ru_maxrss} * 1024);
}

double UsageMeter::cpu_seconds() const {
  return static_cast<double>(std::max(most_, reaped_.sum() + lost_.sum())) / 1e6;
}

}  // namespace plumb
