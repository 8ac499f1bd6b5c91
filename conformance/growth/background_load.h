#pragma once

#include <sys/types.h>

#include <vector>

namespace plumb {

/// Other people's programs on a shared machine: while this lives, a process for each processor computes, walks through
/// more memory than a cache holds, and rests, in turns of random length below half a second. They end with this
/// process, however it ends.
class BackgroundLoad {
 public:
  /// Throws std::system_error where no process can be made.
  explicit BackgroundLoad(int processes);
  ~BackgroundLoad();
  BackgroundLoad(const BackgroundLoad&) = delete;
  BackgroundLoad& operator=(const BackgroundLoad&) = delete;

 private:
  std::vector<pid_t> children_;
};

}  // namespace plumb
