// How much two threads help: wall time of the same rays by one and by two. It says something on an idle machine only.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <atomic>
#include <thread>

#include "bench/race/rows.h"

namespace plumb::bench {
namespace {

/// Wall time of `threads` threads that take the set's rays by blocks.
double wall_seconds(const Peer& peer, const RaySet& set, int threads) {
  constexpr std::size_t kBlock = 512;
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (;;) {
      const std::size_t begin = next.fetch_add(kBlock);
      if (begin >= set.rays.size()) return;
      benchmark::DoNotOptimize(ask(peer, set, {begin, std::min(begin + kBlock, set.rays.size())}));
    }
  };
  const double start = seconds_on(CLOCK_MONOTONIC);
  std::vector<std::jthread> others;
  for (int i = 1; i < threads; ++i) others.emplace_back(work);
  work();
  others.clear();
  return seconds_on(CLOCK_MONOTONIC) - start;
}

void scaling(benchmark::State& state, const std::string& mesh, std::string_view rays, std::size_t count) {
  Arena& arena = arena_of(mesh);
  const RaySet& set = arena.rays(rays, count);
  std::vector<const Contestant*> contestants;
  for (const Contestant& contestant : arena.contestants())
    if (!contestant.kind->batches && contestant.kind->most_rays > count) contestants.push_back(&contestant);
  std::vector<std::vector<double>> ratios(contestants.size());
  for (auto _ : state) {
    double total = 0;
    for (std::size_t i = 0; i < contestants.size(); ++i) {
      const double one = wall_seconds(*contestants[i]->peer, set, 1);
      const double two = wall_seconds(*contestants[i]->peer, set, 2);
      ratios[i].push_back(one / two);
      total += one + two;
    }
    state.SetIterationTime(total);
  }
  for (std::size_t i = 0; i < contestants.size(); ++i)
    state.counters[of(kScaling, contestants[i]->kind->name)] = median(ratios[i]);
}

}  // namespace

void register_thread_rows(const std::vector<std::string>& meshes, const RaceSize& size) {
  for (const std::string& mesh : meshes)
    for (const std::string rays : {"primary", "incoherent"})
      benchmark::RegisterBenchmark((kThreads + ("/" + mesh + "/" + rays)).c_str(),
                                   [=](benchmark::State& state) { scaling(state, mesh, rays, size.rays); })
          ->UseManualTime()
          ->Iterations(size.rounds)
          ->Unit(benchmark::kMillisecond);
}

}  // namespace plumb::bench
