// Ways in which a submission, or who grades it, once led the grading astray.

#include "conformance/judge/grade_rules_fixture.h"

namespace plumb {
namespace {

using testing::ElementsAre;

using GradeFaultsTest = GradeRulesTest;

TEST_F(GradeFaultsTest, ABrokenOwnCommandIsTheSubmissionsFault) {
  int broken = 0;
  for (const char* text :
       {"[runner]\nrender = [\"\"]\n", "[runner]\nrender = [\"a\\u0000b\"]\n",
        "[runner]\nbuild = [[\"\"]]\nrender = [\"x\"]\n", "[runner]\nbuild = [[\"mkfifo\", \"p\"]]\nrender = [\"x\"]\n",
        "[runner]\nbuild = [[\"/bin/sh\", \"-c\", \"rm -rf ../build\"]]\nrender = [\"x\"]\n"}) {
    write("sub/submission.toml", text);
    EXPECT_THAT(outcomes(grade_by(suite("own_runner = true", "") + a_case("a"))), ElementsAre("a: fail (build)"))
        << text;
    ++broken;
  }
  EXPECT_EQ(broken, 5);
}

TEST_F(GradeFaultsTest, ARelativeOutInsideTheSubmissionIsRefused) {
  GradeRequest r = request(suite() + a_case("a"));
  r.out = "results";
  const fs::path home = fs::current_path();
  fs::current_path(folder_ / "sub");
  EXPECT_THROW(grade(r), InputError);
  fs::current_path(home);
  EXPECT_FALSE(fs::exists(folder_ / "sub/results"));
}

TEST_F(GradeFaultsTest, NeighboursOfTheResultsAreNotLost) {
  for (const char* name : {"out.older/mine.txt", "out.partial/mine.txt"}) write(name, "");
  EXPECT_THAT(outcomes(grade_by(suite() + a_case("a"))), ElementsAre("a: pass"));
  for (const char* name : {"out.older/mine.txt", "out.partial/mine.txt"})
    EXPECT_TRUE(fs::exists(folder_ / name)) << name;
}

TEST_F(GradeFaultsTest, SomebodyElsesResultsAreNotReplaced) {
  write("out/results.json", "{\"tests\": []}");  // Gradescope's
  EXPECT_THROW(grade_by(suite() + a_case("a")), InputError);
  EXPECT_TRUE(fs::exists(folder_ / "out/results.json"));
}

TEST_F(GradeFaultsTest, AnOlderResultSetIsReplacedAndNothingIsLeftBeside) {
  for (int run = 0; run < 2; ++run) EXPECT_THAT(outcomes(grade_by(suite() + a_case("a"))), ElementsAre("a: pass"));
  int beside = 0;
  for (const auto& entry : fs::directory_iterator(folder_))
    beside += entry.path().filename().string().starts_with("out.");
  EXPECT_EQ(beside, 0);
}

TEST_F(GradeFaultsTest, InputsAreNoOutput) {
  write("big.dat", std::string(2'000'000, 'x'));
  EXPECT_THAT(outcomes(grade_by(suite() + a_case("a", "inputs = [\"big.dat\"]\noutput_mb = 1"))),
              ElementsAre("a: pass"));
}

TEST_F(GradeFaultsTest, WhatComesAfterAnInterruptedCaseIsInterruptedToo) {
  GradeRequest r = request(suite() + a_case("a") + a_case("b", "requires = [\"a\"]"));
  r.progress = [](const std::string&) { interrupt_flag() = true; };
  EXPECT_THAT(outcomes(grade(r)), ElementsAre("a: skipped (interrupted)", "b: skipped (interrupted)"));
}

TEST_F(GradeFaultsTest, NoCaseLeavesAnythingForALaterOne) {
  // What case a leaves beside its folder is gone when case b looks for it.
  write("sub/render.sh", "ls -d ../../*/run/left 2>/dev/null && exit 0; touch left; cp answer \"$2\"\n");
  EXPECT_THAT(outcomes(grade_by(suite() + a_case("a") + a_case("b"))), ElementsAre("a: pass", "b: pass"));
}

TEST_F(GradeFaultsTest, ADestroyedWorkspaceIsSecurityForEveryCaseAfterwards) {
  // The working folders lie in a folder of this test's own, so that the submission finds no others.
  fs::create_directory(folder_ / "tmp");
  ::setenv("TMPDIR", (folder_ / "tmp").c_str(), 1);
  write("sub/render.sh", "cp answer \"$2\"; for f in ../../../../plumb-*/build; do chmod -R u+w $f; rm -rf $f; done\n");
  const ResultSet results = grade_by(suite() + a_case("a") + a_case("b"));
  ::unsetenv("TMPDIR");
  EXPECT_THAT(outcomes(results), ElementsAre("a: security (build_changed)", "b: security (build_changed)"));
}

TEST_F(GradeFaultsTest, TheTimeForAllCasesHoldsForTheBuildToo) {
  write("sub/submission.toml", "[runner]\nbuild = [[\"sleep\", \"600\"]]\nrender = [\"x\"]\n");
  EXPECT_THAT(outcomes(grade_by(suite("own_runner = true\ntotal_seconds = 1", "") + a_case("a"))),
              ElementsAre("a: fail (build)"));
}

TEST_F(GradeFaultsTest, AHugeSubmissionIsRefused) {
  write("sub/huge", "");
  fs::resize_file(folder_ / "sub/huge", std::uintmax_t{1} << 40);  // sparse
  const ResultSet results = grade_by(suite() + a_case("a"));
  EXPECT_THAT(outcomes(results), ElementsAre("a: fail (build)"));
  EXPECT_THAT(first_summary(results), testing::HasSubstr("larger than 1 GiB"));
}

TEST_F(GradeFaultsTest, RepeatCommandsQuoteStrangeNames) {
  fs::rename(folder_ / "sub", folder_ / "a b's");
  GradeRequest r = request(suite() + a_case("a"));
  r.submission = folder_ / "a b's";
  EXPECT_EQ(grade(r).cases.at(0).repeat, "plumb grade 'a b'\\''s' --suite suite.toml --filter a");
}

TEST_F(GradeFaultsTest, APictureOfAnotherNameIsPointedAt) {
  write("sub/render.sh", "cp answer wrong.PNG\n");
  EXPECT_EQ(first_summary(grade_by(suite() + a_case("a"))),
            "there is no picture 'a.txt.png', but there is 'wrong.PNG'");
}

TEST_F(GradeFaultsTest, ABlackExrIsWrongByTheDefaultTolerance) {
  Image image(2, 1);
  write_image(image, folder_ / "black.exr");
  fs::rename(folder_ / "black.exr", folder_ / "sub/answer");
  image.at(0, 0) = {0.5, 0.5, 0.5};
  write_image(image, folder_ / "ref.exr");
  std::string text =
      suite("", "render = [\"/bin/sh\", \"render.sh\", \"{scene}\", \"{output}\"]\noutput = \"{scene}.exr\"") +
      a_case("a");
  text.replace(text.find("ref.png"), 7, "ref.exr");
  EXPECT_THAT(outcomes(grade_by(text)), ElementsAre("a: fail (different)"));
}

TEST_F(GradeFaultsTest, TheSceneMayBeNamedAsOneOfTheInputs) {
  write("scenes/deep.txt", "a scene");
  write("suite.toml",
        suite() +
            "[[case]]\nid = \"a\"\ninputs = [\"scenes/deep.txt\"]\nscene = \"deep.txt\"\nreference = \"ref.png\"\n");
  const Suite read = read_suite(folder_ / "suite.toml");
  EXPECT_EQ(read.cases.at(0).scene, folder_ / "scenes/deep.txt");
  EXPECT_EQ(read.cases.at(0).inputs.size(), 1U);
}

}  // namespace
}  // namespace plumb
