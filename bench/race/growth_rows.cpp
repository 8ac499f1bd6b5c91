// How the time of a primary ray grows with the mesh: the same shape, the same rays, from 10k to 1.5M triangles, all
// sizes interleaved.
#include <benchmark/benchmark.h>

#include "bench/race/race_meshes.h"
#include "bench/race/rows.h"
#include "bench/race/turns.h"

namespace plumb::bench {
namespace {

bool takes_part(const PeerKind& kind) { return !kind.batches && kind.name != "cgal"; }

struct Entry {
  std::size_t triangles;
  Contestant contestant;
  std::vector<double> times;
};

void growth(benchmark::State& state, std::size_t count) {
  std::vector<Entry> entries;
  std::shared_ptr<const TriangleMesh> mesh;
  for (const std::size_t triangles : {10'000, 40'000, 160'000, 600'000, 1'500'000}) {
    mesh = knot_mesh(triangles);
    for (const PeerKind& kind : peer_kinds()) {
      BuildCost ignored;
      if (takes_part(kind)) entries.push_back({mesh->triangles.size(), {&kind, kind.build(mesh, 1, ignored)}, {}});
    }
  }
  const RaySet set = make_ray_set("primary", *mesh, count, nullptr);
  std::size_t round = 0;
  for (auto _ : state) {
    double total = 0;
    for (const std::size_t turn : turns(round++, entries.size())) {
      Entry& entry = entries[turn];
      entry.times.push_back(seconds_a_ray(entry.contestant, set));
      total += entry.times.back() * static_cast<double>(set.rays.size());
    }
    state.SetIterationTime(total);
  }
  for (const Entry& entry : entries)
    state.counters[of(kNanoseconds, entry.contestant.kind->name) + " at " + std::to_string(entry.triangles)] =
        1e9 * median(entry.times);
}

}  // namespace

void register_growth_rows(const RaceSize& size) {
  benchmark::RegisterBenchmark((kGrowth + std::string("/knot/primary")).c_str(),
                               [=](benchmark::State& state) { growth(state, size.rays); })
      ->UseManualTime()
      ->Iterations(size.rounds)
      ->Unit(benchmark::kMillisecond);
}

}  // namespace plumb::bench
