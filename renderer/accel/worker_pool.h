#pragma once

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace plumb {

/// Threads that share a piece of work with the one that made them. They are started once, since a thread's start takes
/// as long as thousands of triangles. What is shared may share on: a thread that waits for others does what is left.
/// Standard threads rather than a task library, so that the thread sanitizer understands them.
///
/// No function here promises an order, so what is computed must not depend on one. The first exception of a shared
/// piece is thrown on to the thread that waits for it, after all that it shared has come to an end.
class WorkerPool {
 public:
  /// `threads` in all, the caller's among them; none is started for fewer than two.
  explicit WorkerPool(int threads);
  ~WorkerPool();
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  int threads() const { return static_cast<int>(others_.size()) + 1; }

  /// Calls `here` and `there`, maybe at the same time.
  template <class Here, class There>
  void both(const Here& here, const There& there) {
    if (others_.empty()) {
      here();
      there();
      return;
    }
    Task task(there);
    share(task);
    try {
      here();
    } catch (...) {
      finish(task);
      throw;
    }
    finish(task);
    if (task.failure) std::rethrow_exception(task.failure);
  }

  /// Calls f(i) for each i in [0, count), which are begun in order by whoever is free.
  template <class F>
  void each(std::size_t count, const F& f) {
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
      for (std::size_t i = next.fetch_add(1); i < count; i = next.fetch_add(1)) f(i);
    };
    with_others(std::min(count, others_.size() + 1), work);
  }

  /// Calls f(begin, end) for the blocks of `length` that [0, count) is cut into; the last may be shorter.
  template <class F>
  void blocks(std::size_t count, std::size_t length, const F& f) {
    each((count + length - 1) / length,
         [&](std::size_t i) { f(i * length, i * length + length < count ? i * length + length : count); });
  }

 private:
  /// A function that some thread calls, on the stack of the one that waits for it.
  struct Task {
    template <class F>
    explicit Task(const F& f) : function(&f), call([](const void* g) { (*static_cast<const F*>(g))(); }) {}
    const void* function;
    void (*call)(const void*);
    std::exception_ptr failure{};
    bool is_done = false;  // of the pool's mutex
  };

  /// Calls `work` so many times at once, as far as threads are free.
  template <class F>
  void with_others(std::size_t times, const F& work) {
    if (times < 2)
      work();
    else
      both([&] { with_others(times - 1, work); }, work);
  }

  void share(Task& task);
  /// Returns when it was called: here, if no thread has begun it.
  void finish(Task& task);
  void run(Task& task, std::unique_lock<std::mutex>& lock);
  void run_next(std::unique_lock<std::mutex>& lock);
  /// Waits until something has been shared or done.
  void wait(std::unique_lock<std::mutex>& lock);
  void serve();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Task*> waiting_;
  std::atomic<std::size_t> events_ = 0;  // changed under the mutex only
  bool is_over_ = false;
  std::vector<std::jthread> others_;
};

}  // namespace plumb
