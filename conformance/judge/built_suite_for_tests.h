#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "conformance/diagnosis/fingerprint.h"
#include "conformance/envelopes/envelope.h"
#include "conformance/judge/score_suite.h"
#include "conformance/sandbox/run_process.h"
#include "renderer/image/write_image.h"
#include "renderer/math/input_error.h"

namespace plumb {

namespace fs = std::filesystem;

/// A built suite of gray pictures of 8 x 6 pixels, made by hand: level 100 is right in the cases a, b and c, where c
/// may be 140 by the variant `up`; and programs for it, that copy a picture.
class BuiltSuiteTest : public testing::Test {
 protected:
  static constexpr int kWidth = 8, kHeight = 6;

  BuiltSuiteTest() {
    std::string name = (fs::temp_directory_path() / "plumb-score-test-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder for the test");
    folder_ = fs::canonical(name);
    interrupt_flag() = false;
    std::string suite =
        "[suite]\nid = \"s\"\nschema = 1\nfingerprints = \"fingerprints\"\nown_runner = true\n"
        "[[variant]]\nid = \"nearest\"\n[[variant]]\nid = \"up\"\nsamples = \"up\"\n";
    for (const std::string id : {"a", "b", "c"}) {
      write("built/" + id + ".txt", id);
      write_envelope(envelope(100), folder_ / "built" / id / "nearest");
      if (id == "c") write_envelope(envelope(140), folder_ / "built/c/up");
      suite += "[[case]]\nid = \"" + id + "\"\nscene = \"" + id + ".txt\"\nenvelopes = [\"" + id + "/nearest\", \"" +
               id + (id == "c" ? "/up\"]\n" : "/nearest\"]\n");
    }
    write("built/suite.toml", suite);
    fs::create_directories(folder_ / "built/fingerprints");
    write_program("tracer", {100, 100, 100});
  }
  ~BuiltSuiteTest() override {
    interrupt_flag() = false;
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }

  void write(const fs::path& name, const std::string& text) const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }

  static std::vector<std::uint8_t> gray(int level) {
    return std::vector<std::uint8_t>(3 * kWidth * kHeight, static_cast<std::uint8_t>(level));
  }
  /// All of one level but for the first so many pixels, which are black.
  static StoredPicture picture(int level, int wrong = 0) {
    std::vector<std::uint8_t> levels = gray(level);
    std::fill_n(levels.begin(), 3 * wrong, std::uint8_t{0});
    return {std::move(levels), kWidth, kHeight};
  }
  static Envelope envelope(int level) {
    Envelope e;
    e.width = kWidth, e.height = kHeight;
    e.nominal = e.low = e.high = gray(level);
    e.reasons.assign(kWidth * kHeight, PixelReason::interior);
    return e;
  }

  /// A program that draws the cases a, b and c in these levels, and answers as our probe, or as `probe` says.
  void write_program(const std::string& name, const std::vector<int>& levels,
                     const std::string& probe = "exec '" PLUMB_PROGRAM "' probe") const {
    const fs::path answers = folder_ / "answers" / name;
    fs::create_directories(answers);
    for (std::size_t i = 0; i < levels.size(); ++i)
      write_png(gray(levels[i]), kWidth, kHeight, answers / (std::string(1, static_cast<char>('a' + i)) + ".txt.png"));
    const fs::path file = name == "tracer" ? fs::path("tracer") : fs::path("mutants") / name;
    write(file, "#!/bin/sh\nif [ \"$1\" = probe ]; then " + probe + "; fi\ncp '" + answers.string() +
                    "'/\"$(basename \"$2\")\".png \"$4\"\n");
    fs::permissions(folder_ / file, fs::perms::owner_exec, fs::perm_options::add);
  }
  /// A probe that is ours but for the matrices, at which it crashes.
  static inline const std::string kCrashesAtMatrices =
      "exec '" PLUMB_TEST_SUBJECTS "/spoiling_probe' crash matrices '" PLUMB_PROGRAM "' probe";

  /// The text about a mutant; `claim`: its `caught_by`, `accepted` or `equivalent`.
  void write_mutant(const std::string& id, const std::string& claim) const {
    write("known/" + id + ".toml", "name = \"The mistake " + id + "\"\nhint = \"Mind " + id +
                                       ".\"\nstep = \"lights\"\nfile = \"a.cpp\"\nfind = '''x'''\nreplace = '''y'''\n" +
                                       claim + "\n");
  }
  void write_pictures(const std::string& id, std::map<std::string, StoredPicture> pictures,
                      std::vector<std::string> no_picture = {}) const {
    Fingerprint f;
    f.id = id, f.name = "The mistake " + id, f.hint = "Mind " + id + ".", f.step = "lights";
    f.pictures = std::move(pictures), f.no_picture = std::move(no_picture);
    write_fingerprint(f, folder_ / "built/fingerprints" / id);
  }

  SuiteScoreRequest request(const std::string& filter = "") const {
    SuiteScoreRequest request;
    request.built = folder_ / "built";
    request.mutants = folder_ / "mutants";
    request.known_mistakes = folder_ / "known";
    request.tracer = folder_ / "tracer";
    request.filter = filter;
    request.intensity = 0.001;
    return request;
  }
  SuiteScore score(const std::string& filter = "") const { return score_suite(request(filter)); }

  fs::path folder_;
};

}  // namespace plumb
