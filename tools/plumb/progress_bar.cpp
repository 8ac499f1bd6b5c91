#include "tools/plumb/progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

namespace plumb {

ProgressBar::ProgressBar(std::string label) : label_(std::move(label)), on_terminal_(::isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
  if (on_terminal_ && percent_ >= 0) fmt::print(stderr, "\r\x1b[K");
}

void ProgressBar::show(double share) {
  const int percent = static_cast<int>(share * 100);
  if (!on_terminal_ || percent == percent_) return;
  percent_ = percent;
  fmt::print(stderr, "\r{} [{:<25}] {:3}%", label_, std::string(static_cast<std::size_t>(percent / 4), '='), percent);
  std::fflush(stderr);
}

}  // namespace plumb
