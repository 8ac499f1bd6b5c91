#include <atomic>

#include "reference/exact_hit.h"
#include "reference/stage_counters.h"

namespace plumb {
namespace {

std::atomic<std::uint64_t> total_filter, total_expansion, total_rational;

}  // namespace

StageCounters::~StageCounters() {
  total_filter += filter;
  total_expansion += expansion;
  total_rational += rational;
}

ExactStages exact_stages() { return {total_filter, total_expansion, total_rational}; }

void reset_exact_stages() { total_filter = total_expansion = total_rational = 0; }

}  // namespace plumb
