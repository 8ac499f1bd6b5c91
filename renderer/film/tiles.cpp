#include "renderer/film/tiles.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

namespace plumb {

std::vector<PixelRect> tiles_of(const PixelRect& rect) {
  constexpr int kSide = 32;
  std::vector<PixelRect> tiles;
  for (int y = 0; y < rect.height; y += kSide)
    for (int x = 0; x < rect.width; x += kSide)
      tiles.push_back({rect.x + x, rect.y + y, std::min(kSide, rect.width - x), std::min(kSide, rect.height - y)});
  return tiles;
}

int thread_count(int wanted) {
  return wanted > 0 ? wanted : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

// Standard threads rather than a task library: the thread sanitizer understands them without suppressions, so that
// a race in a tracer shows.
void for_each_item(int threads, int count, const std::function<void(int, int)>& work) {
  std::atomic<int> next{0};
  std::mutex mutex;
  std::exception_ptr failure;
  const auto run = [&](int worker) {
    for (int item = next.fetch_add(1); item < count; item = next.fetch_add(1)) {
      try {
        work(worker, item);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!failure) failure = std::current_exception();
        next = count;
      }
    }
  };
  {
    std::vector<std::jthread> others;
    for (int worker = 1; worker < std::min(threads, count); ++worker) others.emplace_back(run, worker);
    run(0);
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace plumb
