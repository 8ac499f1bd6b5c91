// What judging costs: a right picture of 450 x 450 by its envelope, and a wrong one held against 60 known mistakes;
// processor time, with the reading and decoding of every file.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "bench/race/clocks.h"
#include "conformance/compare/judge_picture.h"
#include "conformance/diagnosis/diagnose.h"
#include "conformance/envelopes/judge_envelope.h"
#include "conformance/envelopes/make_envelope.h"
#include "renderer/image/write_image.h"
#include "renderer/kinds.h"
#include "scenes/read_scene.h"

namespace plumb::bench {
namespace {

namespace fs = std::filesystem;

constexpr int kSide = 450;
constexpr int kMistakes = 60;

/// A scene of the library at 450 x 450, its envelope and right picture, and the fingerprints of 60 mistakes, on the
/// disk: all as suite building leaves them.
class JudgeBench {
 public:
  JudgeBench() {
    fs::create_directories(folder_);
    const SceneDescription description = scene();
    const MeshTable meshes = load_meshes(description);
    envelope_ = make_envelope({.description = description, .meshes = meshes, .variant = {}});
    write_envelope(envelope_, folder_ / "envelope");
    write_png(envelope_.nominal, kSide, kSide, folder_ / "right.png");
    for (int i = 0; i < kMistakes; ++i) {
      // 60 programs that are wrong all over, each in its own way.
      TextbookOptions options = textbook_options(description);
      options.shift_x = 0.5 + 0.05 * (i % 8), options.shift_y = 0.3 * (i / 8);
      const std::vector<std::uint8_t> levels =
          levels_of(textbook_picture(textbook_samples(description, meshes, options, 0), options));
      Fingerprint f;
      f.id = fmt::format("mistake-{:02}", i), f.name = f.id, f.hint = "none", f.step = "camera";
      f.pictures.emplace("glazed", StoredPicture(levels, kSide, kSide));
      write_fingerprint(f, folder_ / "fingerprints" / f.id);
      if (i == 17) write_png(levels, kSide, kSide, folder_ / "wrong.png");
    }
  }
  ~JudgeBench() { fs::remove_all(folder_); }
  JudgeBench(const JudgeBench&) = delete;
  JudgeBench& operator=(const JudgeBench&) = delete;

  /// From the two files to the verdict.
  Verdict judge() const {
    const Envelope envelope = read_envelope(folder_ / "envelope");
    Picture reference;
    reference.width = envelope.width, reference.height = envelope.height;
    reference.samples.assign(envelope.nominal.begin(), envelope.nominal.end());
    const PictureJudgement opened = open_picture(folder_ / "right.png", reference);
    return judge_findings(compare_with_envelope(*opened.picture, envelope, 1), *opened.picture, envelope, 1).verdict;
  }
  std::string diagnose() const {
    const std::vector<std::uint8_t> levels = StoredPicture(folder_ / "wrong.png").levels(kSide, kSide);
    const std::vector<DiagnosisCase> cases{{.id = "glazed", .envelope = &envelope_, .tolerance = 1, .levels = levels}};
    const Diagnosis found = plumb::diagnose(cases, read_fingerprints(folder_ / "fingerprints"));
    return found.suspicions.empty() ? "unknown" : found.suspicions.front().id;
  }

 private:
  SceneDescription scene() const {
    const fs::path library = fs::path(PLUMB_LIBRARY);
    std::ifstream stream(library / "glazed.xml");
    std::stringstream text;
    text << stream.rdbuf();
    const fs::path file = folder_ / "glazed.xml";
    std::ofstream(file) << std::regex_replace(text.str(), std::regex("<image>[^<]*</image>"),
                                              fmt::format("<image>{} {}</image>", kSide, kSide));
    return read_scene(file, renderer_kinds(Dialect::pa3_2011));
  }

  fs::path folder_ = fs::temp_directory_path() / fmt::format("plumb-judge-bench-{}", ::getpid());
  Envelope envelope_;
};

const JudgeBench& judge_bench() {
  static const JudgeBench bench;
  return bench;
}

template <class Work>
void timed(benchmark::State& state, const Work& work) {
  std::vector<double> seconds;
  judge_bench();
  for (auto _ : state) {
    const double start = seconds_on(CLOCK_PROCESS_CPUTIME_ID);
    if (!work()) state.SkipWithError("the answer is not the right one");
    seconds.push_back(seconds_on(CLOCK_PROCESS_CPUTIME_ID) - start);
    state.SetIterationTime(seconds.back());
  }
  if (!seconds.empty()) state.counters["median ms"] = 1e3 * median(seconds);
}

void judge_right_picture(benchmark::State& state) {
  timed(state, [] { return judge_bench().judge() == Verdict::pass; });
}
void diagnose_wrong_picture(benchmark::State& state) {
  timed(state, [] { return judge_bench().diagnose() == "mistake-17"; });
}

BENCHMARK(judge_right_picture)
    ->Name("judge a right picture, 450x450")
    ->UseManualTime()
    ->Iterations(25)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(diagnose_wrong_picture)
    ->Name("diagnose a wrong picture, 450x450, against 60 mistakes")
    ->UseManualTime()
    ->Iterations(9)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace plumb::bench

BENCHMARK_MAIN();
