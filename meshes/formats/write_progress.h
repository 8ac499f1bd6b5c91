#pragma once

#include <cstddef>
#include <functional>
#include <utility>

namespace plumb {

/// Tells a function, which may be empty, the share of the steps that are done, about a thousand times in all.
class WriteProgress {
 public:
  WriteProgress(std::function<void(double)> tell, std::size_t steps)
      : tell_(std::move(tell)), steps_(steps), stride_(steps / 1024 + 1) {}

  void step() {
    if (++done_ % stride_ != 0 || !tell_) return;
    tell_(done_ < steps_ ? static_cast<double>(done_) / static_cast<double>(steps_) : 1.0);
  }

 private:
  std::function<void(double)> tell_;
  std::size_t steps_, stride_, done_ = 0;
};

}  // namespace plumb
