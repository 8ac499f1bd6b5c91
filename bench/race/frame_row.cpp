// A whole frame, from a mesh in a text file to a picture, by plumb and by POV-Ray with one thread: processor time of
// the processes in turn, and how far the pictures are apart.
#include <benchmark/benchmark.h>

#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "bench/child_process.h"
#include "bench/race/frame_scene.h"
#include "bench/race/race_meshes.h"
#include "bench/race/rows.h"
#include "renderer/image/read_picture.h"

namespace plumb::bench {
namespace {

namespace fs = std::filesystem;

/// The processor time of a program that succeeds.
double cpu_seconds_of(const std::vector<std::string>& arguments, const fs::path& folder) {
  const ChildRun run = run_child(arguments, folder);
  if (run.exit_status != 0) throw std::runtime_error(arguments[0] + " failed");
  return run.cpu_seconds;
}

/// How many pixels have a level that is off by more than 8 of 255: silhouettes and shadows' edges, where rays of
/// both programs go through other points, and no more.
std::size_t other_pixels(const fs::path& folder) {
  const Picture ours = read_picture(folder / "plumb.png"), theirs = read_picture(folder / "povray.png");
  if (ours.width != theirs.width || ours.height != theirs.height)
    throw std::runtime_error("the pictures differ in size");
  std::size_t other = 0;
  for (int y = 0; y < ours.height; ++y) {
    for (int x = 0; x < ours.width; ++x) {
      bool far = false;
      for (std::size_t k = 0; k < 3; ++k) far = far || std::fabs(ours.pixel(x, y)[k] - theirs.pixel(x, y)[k]) > 8;
      other += far;
    }
  }
  return other;
}

void frame(benchmark::State& state) {
  const auto mesh = knot_mesh(400'000);
  const fs::path folder = PLUMB_FRAME_FOLDER;
  write_frame_scene(*mesh, folder);
  std::vector<double> ours, theirs, ratios;
  for (auto _ : state) {
    try {
      ours.push_back(
          cpu_seconds_of({PLUMB_PROGRAM, "render", "--threads", "1", "-o", "plumb.png", "scene.xml"}, folder));
      theirs.push_back(cpu_seconds_of(
          {"povray", "+Iscene.pov", "+Opovray.png", "+W640", "+H480", "+WT1", "-A", "-D", "+FN8", "File_Gamma=2.2"},
          folder));
    } catch (const std::runtime_error& fault) {
      state.SkipWithError(fault.what());
      break;
    }
    ratios.push_back(theirs.back() / ours.back());
    state.SetIterationTime(ours.back() + theirs.back());
  }
  if (ratios.empty()) return;
  state.counters[of(kFrame, "plumb")] = median(ours);
  state.counters[of(kFrame, "povray")] = median(theirs);
  state.counters[of(kRatio, "plumb")] = median(ratios);
  state.counters["other pixels"] = static_cast<double>(other_pixels(folder));
  state.counters["triangles"] = static_cast<double>(mesh->triangles.size());
}

}  // namespace

void register_frame_row(const RaceSize& size) {
  benchmark::RegisterBenchmark((kFrameTable + std::string("/knot400k")).c_str(), frame)
      ->UseManualTime()
      ->Iterations(size.rounds)
      ->Unit(benchmark::kMillisecond);
}

}  // namespace plumb::bench
