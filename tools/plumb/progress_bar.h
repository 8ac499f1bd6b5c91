#pragma once

#include <string>

namespace plumb {

/// A bar on standard error, drawn only where that is a terminal.
class ProgressBar {
 public:
  /// `label` stands before the bar.
  explicit ProgressBar(std::string label);
  /// Erases the bar.
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  /// Draws again if a whole percent has been gained. From one thread at a time.
  void show(double share);

 private:
  std::string label_;
  bool on_terminal_;
  int percent_ = -1;
};

}  // namespace plumb
