#pragma once

#include <cstddef>
#include <thread>
#include <vector>

namespace plumb {

/// Calls f(begin, end) for parts of 0 .. count - 1, one a thread.
template <class F>
void in_parts(std::size_t count, int threads, const F& f) {
  const std::size_t parts = count < 10000 ? 1 : static_cast<std::size_t>(threads);
  std::vector<std::jthread> others;
  for (std::size_t i = 1; i < parts; ++i)
    others.emplace_back([&, i] { f(count * i / parts, count * (i + 1) / parts); });
  f(0, count / parts);
}

}  // namespace plumb
