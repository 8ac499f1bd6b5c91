// What FLIP costs beside `idiff -p`, the perceptual comparison of OpenImageIO, on the same pairs of pictures in the
// same run: processor time, user and system, in turns. Ours decodes the two files as well, but starts no process; so it
// is also held against what `idiff -p` takes longer than plain `idiff`, which is its comparison alone.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <filesystem>

#include "bench/child_process.h"
#include "bench/race/clocks.h"
#include "conformance/compare/flip.h"
#include "conformance/compare/picture_faults.h"
#include "conformance/compare/wrong_regions.h"
#include "renderer/image/read_picture.h"

namespace plumb::bench {
namespace {

namespace fs = std::filesystem;

template <class Work>
double cpu_seconds_of(const Work& work) {
  const double start = seconds_on(CLOCK_PROCESS_CPUTIME_ID);
  benchmark::DoNotOptimize(work());
  return seconds_on(CLOCK_PROCESS_CPUTIME_ID) - start;
}

void flip_and_idiff(benchmark::State& state, const std::string& name) {
  const fs::path folder = PLUMB_FLIP_PAIRS;
  const std::string reference_name = name + ".reference.png", test_name = name + ".test.png";
  std::vector<double> ours, compared, faults, theirs, plain, ratios, net_ratios;
  for (auto _ : state) {
    try {
      theirs.push_back(run_child({"idiff", "-p", test_name, reference_name}, folder).cpu_seconds);
      plain.push_back(run_child({"idiff", test_name, reference_name}, folder).cpu_seconds);
    } catch (const std::runtime_error& fault) {
      state.SkipWithError(fault.what());
      break;
    }
    Picture reference, test;
    const double decoding = cpu_seconds_of([&] {
      reference = read_picture(folder / reference_name);
      test = read_picture(folder / test_name);
      return test.width;
    });
    compared.push_back(cpu_seconds_of([&] { return flip(reference, test).mean; }));
    faults.push_back(cpu_seconds_of([&] {
      return wrong_regions(wrong_pixels(reference, test, 1)).wrong +
             static_cast<std::int64_t>(picture_faults(reference, test, 1).size());
    }));
    ours.push_back(decoding + compared.back());
    ratios.push_back(theirs.back() / ours.back());
    net_ratios.push_back((theirs.back() - plain.back()) / compared.back());
    state.SetIterationTime(ours.back() + theirs.back());
  }
  if (ratios.empty()) return;
  state.counters["idiff -p ms"] = 1e3 * median(theirs);
  state.counters["idiff ms"] = 1e3 * median(plain);
  state.counters["decode+flip ms"] = 1e3 * median(ours);
  state.counters["flip ms"] = 1e3 * median(compared);
  state.counters["regions+faults ms"] = 1e3 * median(faults);
  state.counters["ratio"] = median(ratios);
  state.counters["ratio without start and decoding"] = median(net_ratios);
}

}  // namespace
}  // namespace plumb::bench

int main(int argc, char** argv) {
  const std::filesystem::path folder = PLUMB_FLIP_PAIRS;
  for (const char* name : {"glazed-ball", "sphereSquished", "bunny500_norms", "solids"}) {
    if (!std::filesystem::exists(folder / (std::string(name) + ".test.png"))) {
      std::fprintf(stderr, "%s has no pair %s: nothing to measure\n", folder.c_str(), name);
      return 1;
    }
    benchmark::RegisterBenchmark((std::string("flip/") + name).c_str(), plumb::bench::flip_and_idiff, name)
        ->UseManualTime()
        ->Iterations(7)
        ->Unit(benchmark::kMillisecond);
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
