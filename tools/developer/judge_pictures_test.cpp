#include "tools/developer/judge_pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "conformance/judge/build_suite.h"
#include "tools/developer/planted_mistakes.h"

// Programs that share no code with what made the envelopes, built and run: right ones in another way, one that cuts its
// colours off, and a wrong one. correct_variants.sh does the same with all of them and all scenes.

namespace plumb {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = PLUMB_SOURCE_DIR;
const fs::path kOut = fs::path(::testing::TempDir()) / "judge-pictures";
constexpr const char* kScenes[] = {"phong", "glass", "cylinder", "mesh-smooth", "antialiasing"};

/// The scenes as they are, without pictures, and a suite of them.
Suite built_suite() {
  fs::remove_all(kOut);
  fs::create_directories(kOut / "scenes");
  std::ofstream suite(kOut / "suite.toml");
  suite << "[suite]\nid = 'right-programs'\nschema = 1\nown_runner = true\n[[variant]]\nid = 'course'\n";
  for (const std::string name : kScenes) {
    const fs::path scene = kRoot / "scenes/pa3" / (name + ".xml");
    suite << "[[case]]\nid = '" << name << "'\nrequirement = 'x'\nscene = '" << scene.string() << "'\ninputs = ['"
          << scene.string() << "'";
    fs::copy_file(scene, kOut / "scenes" / scene.filename());
    for (const std::string mesh : {"cloth.msh", "knot.msh"}) {
      if (name != "mesh-smooth") continue;
      suite << ", '" << (kRoot / "scenes/pa3" / mesh).string() << "'";
      fs::copy_file(kRoot / "scenes/pa3" / mesh, kOut / "scenes" / mesh);
    }
    suite << "]\n";
  }
  suite.close();
  SuiteBuildRequest request;
  request.suite = kOut / "suite.toml", request.out = kOut / "built";
  request.plumb_version = "test";
  build_suite(request);
  return read_suite(kOut / "built" / "suite.toml");
}

/// The C++ example with all of these changes, to be built; returns the folder where its pictures will be.
fs::path planted(const std::string& label, const fs::path& changes, const std::vector<std::string>& ids) {
  const std::vector<PlantedMistake> known = read_planted_mistakes(kRoot / "conformance/mutants" / changes);
  SourceTree sources = read_sources(kRoot, program_of(known));
  for (const std::string& id : ids) {
    const auto change = std::ranges::find(known, id, &PlantedMistake::id);
    EXPECT_NE(change, known.end()) << id;
    sources = plant(*change, sources);
  }
  const fs::path folder = kOut / "programs" / label;
  fs::create_directories(folder);
  std::ofstream(folder / "tracer.cpp") << sources.at("examples/cpp-correct/tracer.cpp");
  return folder;
}

TEST(JudgePictures, FindsNoFaultWithRightProgramsAndWarnsOfThoseThatCutOff) {
  const Suite suite = built_suite();
  const fs::path right = planted("right", "correct/cpp",
                                 {"half-chord", "triangle-by-plane", "camera-by-steps", "offset-1e-5",
                                  "fresnel-by-transmission", "half-vector-divided-late", "refraction-by-tangent"});
  const fs::path cut_off = planted("cut-off", "correct/cpp", {"levels-cut-off"});
  const fs::path wrong = planted("wrong", "planted/cpp", {"fresnel-schlick"});
  const std::string command = "bash '" + (kRoot / "tools/developer/planted_pictures.sh").string() + "' '" +
                              (kOut / "programs").string() + "' '" + (kOut / "scenes").string() + "'";
  ASSERT_EQ(std::system(command.c_str()), 0);

  const JudgedPictures of_right = judge_pictures(suite, right);
  EXPECT_EQ(of_right.wrong_pixels(), 0);
  ASSERT_EQ(of_right.cases.size(), std::size(kScenes));
  for (const JudgedPicture& p : of_right.cases) EXPECT_EQ(p.result.verdict, Verdict::pass) << p.id;

  const JudgedPictures of_cut_off = judge_pictures(suite, cut_off);
  EXPECT_EQ(of_cut_off.wrong_pixels(), 0);
  ASSERT_EQ(of_cut_off.cases.size(), std::size(kScenes));
  for (const JudgedPicture& p : of_cut_off.cases) {
    EXPECT_EQ(p.result.verdict, Verdict::quality_warning) << p.id;
    EXPECT_EQ(p.result.cause, "bias") << p.id;
  }

  const JudgedPictures of_wrong = judge_pictures(suite, wrong);
  ASSERT_EQ(of_wrong.cases.size(), std::size(kScenes));
  for (const JudgedPicture& p : of_wrong.cases)
    EXPECT_EQ(p.result.verdict, p.id == "glass" ? Verdict::fail : Verdict::pass) << p.id;
  EXPECT_GT(of_wrong.wrong_pixels(), 100);

  const JudgedPictures of_nothing = judge_pictures(suite, kOut / "scenes");
  EXPECT_EQ(of_nothing.unusable.size(), std::size(kScenes));
}

}  // namespace
}  // namespace plumb
