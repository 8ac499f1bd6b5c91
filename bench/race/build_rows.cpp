// Builds of each mesh by one and by two threads, and the bytes that they leave.
#include <benchmark/benchmark.h>

#include <array>

#include "bench/race/race_meshes.h"
#include "bench/race/rows.h"
#include "bench/race/turns.h"

namespace plumb::bench {
namespace {

struct BuildTimes {
  std::array<std::vector<double>, 2> cpu, caller, wall;  ///< by number of threads
  double bytes = 0;
};

/// Nothing else with more threads is alive meanwhile: Embree gives a device as many as the largest of all has.
void build_once(const PeerKind& kind, const std::shared_ptr<const TriangleMesh>& mesh, int threads, BuildTimes& times) {
  BuildCost cost;
  const std::unique_ptr<Peer> peer = kind.build(mesh, threads, cost);
  const auto place = static_cast<std::size_t>(threads - 1);
  times.cpu[place].push_back(1e3 * cost.cpu);
  times.caller[place].push_back(1e3 * cost.caller);
  times.wall[place].push_back(1e3 * cost.wall);
  if (threads == 1) times.bytes = static_cast<double>(peer->bytes());
}

void build(benchmark::State& state, const std::string& name) {
  const auto mesh = race_mesh(name);
  std::vector<const PeerKind*> kinds;
  for (const PeerKind& kind : peer_kinds())
    if (!kind.batches && mesh->triangles.size() <= kind.most_triangles) kinds.push_back(&kind);
  std::vector<BuildTimes> times(kinds.size());
  std::size_t round = 0;
  for (auto _ : state) {
    const double start = seconds_on(CLOCK_MONOTONIC);
    for (const std::size_t turn : turns(round++, kinds.size())) {
      // Untimed, once: where another one has left its memory in small pieces, the next to ask for huge pages waits for
      // the system to join them, which made a build of Embree's half as slow again.
      BuildCost ignored;
      kinds[turn]->build(mesh, 1, ignored);
      for (int threads = 1; threads <= kinds[turn]->most_threads; ++threads)
        build_once(*kinds[turn], mesh, threads, times[turn]);
    }
    state.SetIterationTime(seconds_on(CLOCK_MONOTONIC) - start);
  }
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const std::string& peer = kinds[i]->name;
    const auto put = [&](const char* what, const std::vector<double>& values) {
      if (!values.empty()) state.counters[of(what, peer)] = median(values);
    };
    put(kCpu1, times[i].cpu[0]);
    put(kCpu2, times[i].cpu[1]);
    put(kCaller2, times[i].caller[1]);
    put(kWall1, times[i].wall[0]);
    put(kWall2, times[i].wall[1]);
    if (times[i].bytes > 0)
      state.counters[of(kBytes, peer)] = times[i].bytes / static_cast<double>(mesh->triangles.size());
  }
  state.counters["triangles"] = static_cast<double>(mesh->triangles.size());
}

}  // namespace

void register_build_rows(const std::vector<std::string>& meshes, const RaceSize& size) {
  for (const std::string& mesh : meshes)
    benchmark::RegisterBenchmark((kBuild + ("/" + mesh)).c_str(), [=](benchmark::State& state) { build(state, mesh); })
        ->UseManualTime()
        ->Iterations(size.rounds)
        ->Unit(benchmark::kMillisecond);
}

}  // namespace plumb::bench
