#include "renderer/accel/worker_pool.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <stdexcept>

namespace plumb {
namespace {

constexpr int kThreads[] = {0, 1, 2, 3, 8};

TEST(WorkerPool, CallsForEachItemOnce) {
  int pools = 0;
  for (const int threads : kThreads) {
    WorkerPool pool(threads);
    EXPECT_EQ(pool.threads(), std::max(1, threads));
    for (const std::size_t count : {0, 1, 2, 7, 1000}) {
      std::vector<std::atomic<int>> calls(count);
      pool.each(count, [&](std::size_t i) { ++calls[i]; });
      EXPECT_TRUE(std::all_of(calls.begin(), calls.end(), [](int n) { return n == 1; })) << threads << " " << count;
    }
    ++pools;
  }
  EXPECT_EQ(pools, 5);
}

TEST(WorkerPool, CutsIntoBlocksThatCoverAll) {
  WorkerPool pool(3);
  int cases = 0;
  for (const std::size_t count : {0, 1, 99, 100, 101, 12345}) {
    std::vector<int> covered(count);
    std::atomic<std::size_t> longest = 0, blocks = 0;
    pool.blocks(count, 100, [&](std::size_t begin, std::size_t end) {
      ASSERT_LT(begin, end);
      ASSERT_LE(end, count);
      EXPECT_EQ(begin % 100, 0u);
      for (std::size_t i = begin; i < end; ++i) ++covered[i];
      if (end - begin > 100) longest = end - begin;
      ++blocks;
    });
    EXPECT_EQ(longest, 0u);
    EXPECT_EQ(blocks, (count + 99) / 100);
    EXPECT_EQ(std::count(covered.begin(), covered.end(), 1), static_cast<std::ptrdiff_t>(count));
    ++cases;
  }
  EXPECT_EQ(cases, 6);
}

/// The sum of begin .. end - 1 by a tree of shared pieces.
std::size_t sum(WorkerPool& pool, std::size_t begin, std::size_t end) {
  if (end - begin == 1) return begin;
  std::size_t left = 0, right = 0;
  const std::size_t middle = begin + std::max<std::size_t>(1, (end - begin) / 7);
  pool.both([&] { left = sum(pool, begin, middle); }, [&] { right = sum(pool, middle, end); });
  return left + right;
}

TEST(WorkerPool, SharedPiecesMayShareOn) {
  int pools = 0;
  for (const int threads : kThreads) {
    WorkerPool pool(threads);
    for (int i = 0; i < 20; ++i) EXPECT_EQ(sum(pool, 0, 3000), 3000u * 2999 / 2);
    std::atomic<int> inner = 0;
    pool.each(50, [&](std::size_t) { pool.each(50, [&](std::size_t) { ++inner; }); });
    EXPECT_EQ(inner, 2500);
    ++pools;
  }
  EXPECT_EQ(pools, 5);
}

/// Two pieces that wait for each other end only where each has a thread.
TEST(WorkerPool, DoesTwoThingsAtOnce) {
  WorkerPool pool(2);
  std::atomic<int> begun = 0;
  std::thread::id here, there;
  const auto meet = [&](std::thread::id& id) {
    id = std::this_thread::get_id();
    ++begun;
    while (begun < 2) std::this_thread::yield();
  };
  pool.both([&] { meet(here); }, [&] { meet(there); });
  EXPECT_EQ(begun, 2);
  EXPECT_EQ(here, std::this_thread::get_id());
  EXPECT_NE(here, there);
}

TEST(WorkerPool, ThrowsOnAfterAllHasEnded) {
  int thrown = 0;
  for (const int threads : kThreads) {
    WorkerPool pool(threads);
    std::atomic<int> others = 0;
    const auto fail = [] { throw std::runtime_error("a piece"); };
    const auto count = [&] { ++others; };
    EXPECT_THROW(pool.both(fail, count), std::runtime_error);
    EXPECT_THROW(pool.both(count, fail), std::runtime_error);
    EXPECT_THROW(pool.both(fail, fail), std::runtime_error);
    EXPECT_THROW(pool.each(100,
                           [&](std::size_t i) {
                             if (i == 50) fail();
                           }),
                 std::runtime_error);
    EXPECT_GE(others, 1);
    pool.both(count, count);  // goes on
    EXPECT_GE(others, 3);
    thrown += 4;
  }
  EXPECT_EQ(thrown, 20);
}

}  // namespace
}  // namespace plumb
