#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <utility>

namespace plumb {

/// Tells a listener (which may be empty) the share that is done, at most about a hundred times.
class ProgressSteps {
 public:
  ProgressSteps(std::function<void(double)> listener, std::uint64_t steps)
      : listener_(std::move(listener)), steps_(steps), next_(stride()) {}

  /// After each of the steps; the last one tells exactly 1.
  void step() {
    ++done_;
    if (done_ < next_ && done_ != steps_) return;
    next_ = done_ + stride();
    if (listener_) listener_(static_cast<double>(done_) / static_cast<double>(steps_));
  }

 private:
  std::uint64_t stride() const { return std::max<std::uint64_t>(1, steps_ / 100); }

  std::function<void(double)> listener_;
  std::uint64_t steps_, done_ = 0, next_;
};

/// A listener to a part of the work, which hears from 0 to 1 what `whole` hears from `from` to `to`.
inline std::function<void(double)> part_of(std::function<void(double)> whole, double from, double to) {
  if (!whole) return {};
  return [=](double share) { whole(from + share * (to - from)); };
}

}  // namespace plumb
