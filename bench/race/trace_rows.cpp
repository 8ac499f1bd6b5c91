// Single-ray calls on each set of rays, and the same beside Embree's batches.
#include <benchmark/benchmark.h>

#include "bench/race/rows.h"
#include "bench/race/turns.h"

namespace plumb::bench {
namespace {

/// Seconds a ray by contestant and round.
std::vector<std::vector<double>> run_rounds(benchmark::State& state, const std::vector<const Contestant*>& contestants,
                                            const RaySet& set) {
  std::vector<std::vector<double>> times(contestants.size());
  std::size_t round = 0;
  for (auto _ : state) {
    double total = 0;
    for (const std::size_t turn : turns(round++, contestants.size())) {
      times[turn].push_back(seconds_a_ray(*contestants[turn], set));
      total += times[turn].back() * static_cast<double>(set.rays.size());
    }
    state.SetIterationTime(total);
  }
  return times;
}

/// Ratios are taken within each round, then the median.
void count_speeds(benchmark::State& state, const std::vector<const Contestant*>& contestants,
                  const std::vector<std::vector<double>>& times) {
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    std::vector<double> ratios;
    for (std::size_t round = 0; round < times[i].size(); ++round) ratios.push_back(times[0][round] / times[i][round]);
    const std::string& name = contestants[i]->kind->name;
    state.counters[of(kSpeed, name)] = 1e-6 / median(times[i]);
    state.counters[of(kRatio, name)] = median(ratios);
  }
}

void trace(benchmark::State& state, const std::string& mesh, std::string_view rays, std::size_t count) {
  Arena& arena = arena_of(mesh);
  const RaySet& set = arena.rays(rays, count);
  std::vector<const Contestant*> contestants;
  for (const Contestant& contestant : arena.contestants())
    if (!contestant.kind->batches) contestants.push_back(&contestant);
  count_speeds(state, contestants, run_rounds(state, contestants, set));
  const Peer& judge = arena.peer(kJudge);
  for (const Contestant* contestant : contestants) {
    const auto asked = static_cast<double>(slice_for(*contestant->kind, set).count());
    const Differences found = differences(*contestant, judge, set, arena.mesh());
    state.counters[of(kDiffers, contestant->kind->name)] = static_cast<double>(found.all) / asked;
    state.counters[of(kEscapes, contestant->kind->name)] = static_cast<double>(found.escapes) / asked;
  }
  const Tally tally = ask(judge, set, {0, set.rays.size()});
  state.counters["rays"] = static_cast<double>(set.rays.size());
  state.counters["hits"] = static_cast<double>(tally.hits) / static_cast<double>(set.rays.size());
}

/// Embree's batches first, then all that are asked ray by ray.
void batch(benchmark::State& state, const std::string& mesh, std::string_view rays, std::size_t count) {
  Arena& arena = arena_of(mesh);
  const RaySet& set = arena.rays(rays, count);
  std::vector<const Contestant*> contestants;
  for (const bool batches : {true, false})
    for (const Contestant& contestant : arena.contestants())
      if (contestant.kind->batches == batches && contestant.kind->most_rays > count) contestants.push_back(&contestant);
  count_speeds(state, contestants, run_rounds(state, contestants, set));
}

template <class Row>
void add_row(const std::string& table, const std::string& mesh, std::string_view rays, const RaceSize& size,
             const Row& row) {
  benchmark::RegisterBenchmark((table + "/" + mesh + "/" + std::string(rays)).c_str(),
                               [=, count = size.rays](benchmark::State& state) { row(state, mesh, rays, count); })
      ->UseManualTime()
      ->Iterations(size.rounds)
      ->Unit(benchmark::kMillisecond);
}

}  // namespace

void register_trace_rows(const std::vector<std::string>& meshes, const RaceSize& size) {
  for (const std::string& mesh : meshes)
    for (const std::string_view rays : ray_set_names()) add_row(kTrace, mesh, rays, size, trace);
}

void register_batch_rows(const std::vector<std::string>& meshes, const RaceSize& size) {
  for (const std::string& mesh : meshes)
    for (const std::string_view rays : {"primary", "incoherent", "diffuse", "shadow"})
      add_row(kBatch, mesh, rays, size, batch);
}

}  // namespace plumb::bench
