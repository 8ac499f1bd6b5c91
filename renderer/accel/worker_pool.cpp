#include "renderer/accel/worker_pool.h"

#include <system_error>

namespace plumb {

WorkerPool::WorkerPool(int threads) {
  try {
    for (int i = 1; i < threads; ++i) others_.emplace_back([this] { serve(); });
  } catch (const std::system_error&) {
    // Fewer threads than were wished for do the same work.
  }
}

WorkerPool::~WorkerPool() {
  const std::lock_guard lock(mutex_);
  is_over_ = true;
  ++events_;
  changed_.notify_all();
}

void WorkerPool::share(Task& task) {
  const std::lock_guard lock(mutex_);
  waiting_.push_back(&task);
  ++events_;
  changed_.notify_one();
}

void WorkerPool::finish(Task& task) {
  std::unique_lock lock(mutex_);
  // What was shared last is the smallest and the last to be begun by others.
  const auto mine = std::find(waiting_.rbegin(), waiting_.rend(), &task);
  if (mine != waiting_.rend()) {
    waiting_.erase(std::next(mine).base());
    run(task, lock);
  }
  while (!task.is_done) {
    if (waiting_.empty())
      wait(lock);
    else
      run_next(lock);
  }
}

void WorkerPool::run(Task& task, std::unique_lock<std::mutex>& lock) {
  lock.unlock();
  try {
    task.call(task.function);
  } catch (...) {
    task.failure = std::current_exception();
  }
  lock.lock();
  task.is_done = true;
  ++events_;
  changed_.notify_all();
}

void WorkerPool::run_next(std::unique_lock<std::mutex>& lock) {
  Task& task = *waiting_.front();
  waiting_.pop_front();
  run(task, lock);
}

void WorkerPool::wait(std::unique_lock<std::mutex>& lock) {
  // Work comes in bursts: to sleep and be woken would take longer than most pauses.
  constexpr int kPatience = 100;
  const std::size_t seen = events_;
  lock.unlock();
  for (int i = 0; i < kPatience && events_ == seen; ++i) std::this_thread::yield();
  lock.lock();
  changed_.wait(lock, [&] { return events_ != seen; });
}

void WorkerPool::serve() {
  std::unique_lock lock(mutex_);
  for (;;) {
    if (!waiting_.empty())
      run_next(lock);
    else if (is_over_)
      return;
    else
      wait(lock);
  }
}

}  // namespace plumb
