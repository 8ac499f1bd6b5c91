#include "conformance/subject/kernel_cost.h"

#include <algorithm>
#include <chrono>

namespace plumb {
namespace {

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

}  // namespace

AskingCost asking_cost(Subject& nothing, std::size_t rays_a_call, int calls) {
  nothing.load({});
  const std::vector<Ray> rays(rays_a_call, Ray{{0, 0, 1}, {0, 0, -1}});
  std::vector<double> cpu, clock;
  for (int i = 0; i < calls; ++i) {
    const auto start = std::chrono::steady_clock::now();
    nothing.closest(rays);
    clock.push_back(std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count());
    cpu.push_back(1e9 * nothing.last_cpu_seconds().value_or(0));
  }
  const auto count = static_cast<double>(rays_a_call);
  return {median(cpu) / count, median(clock) / count};
}

}  // namespace plumb
