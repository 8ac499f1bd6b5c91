#pragma once

#include <algorithm>
#include <ctime>
#include <vector>

namespace plumb::bench {

/// Seconds on one of the system's clocks: CLOCK_THREAD_CPUTIME_ID (the calling thread's processor time),
/// CLOCK_PROCESS_CPUTIME_ID (that of all threads), CLOCK_MONOTONIC (wall time).
inline double seconds_on(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The middle value, the mean of the two middle ones of an even number. Requires one.
inline double median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

}  // namespace plumb::bench
