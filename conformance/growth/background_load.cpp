#include "conformance/growth/background_load.h"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <system_error>

#include "conformance/families/random.h"

namespace plumb {
namespace {

constexpr std::size_t kWords = std::size_t{8} << 20;  // 64 MiB
constexpr std::int64_t kLongestTurn = 500'000'000;    // nanoseconds

std::int64_t now() {
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return time.tv_sec * std::int64_t{1'000'000'000} + time.tv_nsec;
}

/// Never returns.
[[noreturn]] void work(std::uint64_t index) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  Random random(index, "background-load", 0);
  std::vector<std::uint64_t> memory(kWords, index);
  volatile std::uint64_t sink = 0;
  for (;;) {
    const std::uint32_t kind = random.below(3);
    const std::int64_t end = now() + 1 + static_cast<std::int64_t>(random.unit() * kLongestTurn);
    if (kind == 0) {
      const timespec rest{0, static_cast<long>(end - now() > 0 ? end - now() : 0)};
      ::nanosleep(&rest, nullptr);
      continue;
    }
    while (now() < end) {
      std::uint64_t sum = 0;
      if (kind == 1)
        for (int i = 0; i < 100'000; ++i) sum += random.bits();
      else
        for (std::size_t i = 0; i < kWords; i += 8) sum += ++memory[i];
      sink = sink + sum;
    }
  }
}

}  // namespace

BackgroundLoad::BackgroundLoad(int processes) {
  for (int i = 0; i < processes; ++i) {
    const pid_t child = ::fork();
    if (child < 0)
      throw std::system_error(errno, std::generic_category(), "cannot make a process for the background load");
    if (child == 0) work(static_cast<std::uint64_t>(i));
    children_.push_back(child);
  }
}

BackgroundLoad::~BackgroundLoad() {
  for (const pid_t child : children_) {
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
  }
}

}  // namespace plumb
