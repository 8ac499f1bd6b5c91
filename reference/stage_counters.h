#pragma once

#include <cstdint>

namespace plumb {

/// Counts on the stack which stage decided, and adds itself to exact_stages() in the end.
struct StageCounters {
  StageCounters() = default;
  ~StageCounters();
  StageCounters(const StageCounters&) = delete;
  StageCounters& operator=(const StageCounters&) = delete;

  std::uint64_t filter = 0, expansion = 0, rational = 0;
};

}  // namespace plumb
