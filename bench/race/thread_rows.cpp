// How much two threads help with the same rays: by wall time, which says something on an idle machine only, and by the
// processor time of the slower one, which sees what they take from each other's caches and memory on any machine.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <thread>

#include "bench/race/rows.h"

namespace plumb::bench {
namespace {

struct Times {
  double wall, slower_cpu;
};

/// Thread k of n takes the blocks k, k + n, ... of the set: the same work whatever else the machine does.
Times times_of(const Peer& peer, const RaySet& set, std::size_t threads) {
  constexpr std::size_t kBlock = 512;
  std::vector<double> cpu(threads);
  const auto work = [&](std::size_t place) {
    const double start = seconds_on(CLOCK_THREAD_CPUTIME_ID);
    for (std::size_t begin = kBlock * place; begin < set.rays.size(); begin += kBlock * threads)
      benchmark::DoNotOptimize(ask(peer, set, {begin, std::min(begin + kBlock, set.rays.size())}));
    cpu[place] = seconds_on(CLOCK_THREAD_CPUTIME_ID) - start;
  };
  const double start = seconds_on(CLOCK_MONOTONIC);
  {
    std::vector<std::jthread> others;
    for (std::size_t i = 1; i < threads; ++i) others.emplace_back(work, i);
    work(0);
  }
  return {seconds_on(CLOCK_MONOTONIC) - start, std::ranges::max(cpu)};
}

void scaling(benchmark::State& state, const std::string& mesh, std::string_view rays, std::size_t count) {
  Arena& arena = arena_of(mesh);
  const RaySet& set = arena.rays(rays, count);
  std::vector<const Contestant*> contestants;
  for (const Contestant& contestant : arena.contestants())
    if (!contestant.kind->batches && contestant.kind->most_rays > count) contestants.push_back(&contestant);
  std::vector<std::vector<double>> wall(contestants.size()), cpu(contestants.size());
  for (auto _ : state) {
    double total = 0;
    for (std::size_t i = 0; i < contestants.size(); ++i) {
      const Times one = times_of(*contestants[i]->peer, set, 1), two = times_of(*contestants[i]->peer, set, 2);
      wall[i].push_back(one.wall / two.wall);
      cpu[i].push_back(one.slower_cpu / two.slower_cpu);
      total += one.wall + two.wall;
    }
    state.SetIterationTime(total);
  }
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    state.counters[of(kScaling, contestants[i]->kind->name)] = median(wall[i]);
    state.counters[of(kCpuScaling, contestants[i]->kind->name)] = median(cpu[i]);
  }
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
