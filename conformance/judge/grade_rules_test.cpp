#include "conformance/judge/grade_rules_fixture.h"

namespace plumb {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

TEST_F(GradeRulesTest, AFailedBuildFailsEveryCase) {
  const ResultSet results = grade_by(suite("",
                                           "build = [[\"true\"], [\"/bin/sh\", \"-c\", \"echo the reason; exit 3\"], "
                                           "[\"touch\", \"later\"]]\nrender = [\"./tracer\"]") +
                                     a_case("a") + a_case("b"));
  EXPECT_THAT(outcomes(results), ElementsAre("a: fail (build)", "b: fail (build)"));
  EXPECT_EQ(first_summary(results), "the build failed: '/bin/sh' ended with exit status 3");
  EXPECT_EQ(results.totals().points, 0);
  EXPECT_EQ(results.totals().max_points, 20);
  std::ifstream log(folder_ / "out/build/log.txt");
  const std::string text(std::istreambuf_iterator<char>(log), {});
  EXPECT_THAT(text, HasSubstr("the reason\n"));
  EXPECT_THAT(text, Not(HasSubstr("touch later"))) << "nothing is built after a failure";
}

TEST_F(GradeRulesTest, ACompileErrorIsAFailedBuild) {
  write("sub/main.c", "int main(void) { return no_such_name; }\n");
  EXPECT_THAT(outcomes(grade_by(
                  suite("", "build = [[\"gcc\", \"-o\", \"tracer\", \"{sources:*.c}\"]]\nrender = [\"./tracer\"]") +
                  a_case("a"))),
              ElementsAre("a: fail (build)"));
}

TEST_F(GradeRulesTest, MissingSourcesAreAFailedBuild) {
  const ResultSet results =
      grade_by(suite("", "build = [[\"true\", \"{sources:**/*.java}\"]]\nrender = [\"./tracer\"]") + a_case("a"));
  EXPECT_THAT(outcomes(results), ElementsAre("a: fail (build)"));
  EXPECT_THAT(first_summary(results), HasSubstr("no file of the submission matches '**/*.java'"));
}

TEST_F(GradeRulesTest, AnEndlessBuildIsAFailedBuild) {
  const ResultSet results =
      grade_by(suite("", "build_seconds = 1\nbuild = [[\"sleep\", \"100\"]]\nrender = [\"./tracer\"]") + a_case("a"));
  EXPECT_THAT(outcomes(results), ElementsAre("a: fail (build)"));
  EXPECT_THAT(first_summary(results), HasSubstr("took longer than the 1 s"));
}

TEST_F(GradeRulesTest, AProgramThatWasNotBuiltIsNoPicture) {
  const ResultSet results = grade_by(suite("", "render = [\"./tracer\", \"{scene}\"]") + a_case("a"));
  EXPECT_THAT(outcomes(results), ElementsAre("a: fail (no_picture)"));
  EXPECT_EQ(first_summary(results), "cannot run ./tracer: No such file or directory");
}

TEST_F(GradeRulesTest, ARootThatIsNotFoundIsAFailedBuild) {
  const ResultSet results =
      grade_by(suite("", "root_marker = \"ray/Main.java\"\nrender = [\"./tracer\"]") + a_case("a"));
  EXPECT_THAT(outcomes(results), ElementsAre("a: fail (build)"));
  EXPECT_THAT(first_summary(results), HasSubstr("no folder of the submission holds 'ray/Main.java'"));
}

TEST_F(GradeRulesTest, WithoutItsCommandsASubmissionCannotBeBuilt) {
  const ResultSet results = grade_by(suite("own_runner = true", "") + a_case("a"));
  EXPECT_THAT(outcomes(results), ElementsAre("a: fail (build)"));
  EXPECT_THAT(first_summary(results), HasSubstr("there is no submission.toml"));
}

TEST_F(GradeRulesTest, AMalformedSubmissionFileIsNamedAsTheStudentKnowsIt) {
  for (const char* text : {"[runner]\nrender = \n", "[runner]\nrender = [\"./t\", \"{scenes}\"]\n",
                           "[runner]\nrender = [\"./t\"]\noutput = \"../x.png\"\n"}) {
    write("sub/submission.toml", text);
    const ResultSet results = grade_by(suite("own_runner = true", "") + a_case("a"));
    EXPECT_THAT(outcomes(results), ElementsAre("a: fail (build)")) << text;
    EXPECT_THAT(first_summary(results),
                testing::AnyOf(StartsWith("submission.toml:2:"), StartsWith("submission.toml:3:")));
  }
}

TEST_F(GradeRulesTest, ASubmissionCannotSetLimitsOrPoints) {
  for (const char* text :
       {"[runner]\nrender = [\"/bin/sh\", \"render.sh\", \"{scene}\", \"{output}\"]\nbuild_seconds = 1000\n",
        "[runner]\nrender = [\"/bin/sh\", \"render.sh\", \"{scene}\", \"{output}\"]\n[[case]]\nid = \"a\"\npoints = "
        "100\n",
        "[runner]\nrender = [\"/bin/sh\", \"render.sh\", \"{scene}\", \"{output}\"]\n[suite]\ntotal_seconds = 100\n"}) {
    write("sub/submission.toml", text);
    const ResultSet results = grade_by(suite("own_runner = true", "") + a_case("a"));
    EXPECT_THAT(outcomes(results), ElementsAre("a: fail (build)")) << text;
    EXPECT_THAT(first_summary(results), HasSubstr("unknown key")) << text;
  }
}

TEST_F(GradeRulesTest, ASubmissionsOwnCommandsAreUsedOnlyWhereTheSuiteSaysSo) {
  write("sub/submission.toml", "[runner]\nrender = [\"true\"]\n");
  const ResultSet ignored = grade_by(suite() + a_case("a"));
  EXPECT_THAT(outcomes(ignored), ElementsAre("a: pass"));
  EXPECT_THAT(ignored.notes, Contains(HasSubstr("submission.toml was not read")));
  EXPECT_THAT(outcomes(grade_by(suite("own_runner = true") + a_case("a"))), ElementsAre("a: fail (no_picture)"));
  fs::remove(folder_ / "sub/submission.toml");
  EXPECT_THAT(outcomes(grade_by(suite("own_runner = true") + a_case("a"))), ElementsAre("a: pass"))
      << "the suite's commands stand in";
}

TEST_F(GradeRulesTest, AFailedPrerequisiteSkipsByTheSuitesRule) {
  write("a.txt", "bad");
  const std::string cases =
      a_case("a") + a_case("b", "requires = [\"a\"]") + a_case("c", "requires = [\"b\"]") + a_case("d");
  struct {
    const char* keys;
    double max_points, pending_points;
    bool pending, excluded;
  } const expected[] = {{"", 40, 0, false, false},
                        {"skipped = \"zero\"", 40, 0, false, false},
                        {"skipped = \"excluded\"", 20, 0, false, true},
                        {"skipped = \"manual\"", 20, 20, true, false}};
  for (const auto& e : expected) {
    const ResultSet results = grade_by(suite(e.keys) + cases);
    EXPECT_THAT(outcomes(results), ElementsAre("a: fail (no_picture)", "b: skipped (prerequisite)",
                                               "c: skipped (prerequisite)", "d: pass"));
    EXPECT_EQ(results.cases[1].check.summary, "not judged: 'a' comes first");
    EXPECT_EQ(results.cases[1].pending, e.pending) << e.keys;
    EXPECT_EQ(results.cases[1].excluded, e.excluded) << e.keys;
    EXPECT_EQ(results.totals().points, 10) << e.keys;
    EXPECT_EQ(results.totals().max_points, e.max_points) << e.keys;
    EXPECT_EQ(results.totals().pending_points, e.pending_points) << e.keys;
  }
}

TEST_F(GradeRulesTest, OurOwnFaultCostsNoPoints) {
  GradeRequest r = request(suite() + a_case("a") + a_case("b", "requires = [\"a\"]") + a_case("c"));
  fs::copy_file(folder_ / "ref.png", folder_ / "lost.png");
  r.suite.cases[0].reference = folder_ / "lost.png";
  r.progress = [&](const std::string& what) {
    if (what == "a") fs::remove(folder_ / "lost.png");
  };
  const ResultSet results = grade(r);
  EXPECT_THAT(outcomes(results), ElementsAre("a: internal_error (internal)", "b: skipped (prerequisite)", "c: pass"));
  EXPECT_TRUE(results.cases[0].pending);
  EXPECT_THAT(results.cases[0].check.summary, Not(HasSubstr(folder_.string()))) << "the place stands in usage.json";
  EXPECT_THAT(results.cases[0].internal_message, HasSubstr("lost.png"));
  EXPECT_TRUE(results.cases[1].pending) << "nobody loses points for what comes after our fault";
  EXPECT_EQ(results.totals().points, 10);
  EXPECT_EQ(results.totals().max_points, 10);
  EXPECT_EQ(results.totals().pending_points, 20);
  EXPECT_TRUE(fs::exists(folder_ / "out/results.json"));
}

TEST_F(GradeRulesTest, AnInterruptLeavesTheRestToBeGradedAgain) {
  GradeRequest r = request(suite() + a_case("a") + a_case("b") + a_case("c"));
  r.progress = [](const std::string& what) {
    if (what == "b") interrupt_flag() = true;
  };
  const ResultSet results = grade(r);
  EXPECT_THAT(outcomes(results), ElementsAre("a: pass", "b: skipped (interrupted)", "c: skipped (interrupted)"));
  EXPECT_EQ(results.totals().points, 10);
  EXPECT_EQ(results.totals().max_points, 10);
  EXPECT_EQ(results.totals().pending_points, 20);
  EXPECT_TRUE(fs::exists(folder_ / "out/results.json"));
  EXPECT_TRUE(fs::exists(folder_ / "out/cases/c/case.json"));
}

TEST_F(GradeRulesTest, AnInterruptOfTheBuildCostsNoPoints) {
  GradeRequest r = request(suite("", "build = [[\"sleep\", \"100\"]]\nrender = [\"./tracer\"]") + a_case("a"));
  r.progress = [](const std::string&) { interrupt_flag() = true; };
  const ResultSet results = grade(r);
  EXPECT_THAT(outcomes(results), ElementsAre("a: skipped (interrupted)"));
  EXPECT_EQ(results.totals().pending_points, 10);
}

TEST_F(GradeRulesTest, ASpentBudgetIsATimeoutOfWhatIsLeft) {
  write("sub/render.sh", "grep -q bad \"$1\" && sleep 100\ncp answer \"$2\"\n");
  write("b.txt", "bad");
  const ResultSet results = grade_by(suite("total_seconds = 1.5") + a_case("c", "cpu_seconds = 40") +
                                     a_case("a", "cpu_seconds = 1") + a_case("b", "cpu_seconds = 20"));
  EXPECT_THAT(outcomes(results), ElementsAre("c: timeout (budget_spent)", "a: pass", "b: timeout (budget_spent)"));
  EXPECT_EQ(results.totals().max_points, 30);
}

TEST_F(GradeRulesTest, CheapCasesRunFirstButAfterTheirPrerequisites) {
  const GradeRequest r =
      request(suite() + a_case("a", "cpu_seconds = 9") + a_case("b", "cpu_seconds = 2\nrequires = [\"d\"]") +
              a_case("c", "cpu_seconds = 1") + a_case("d", "cpu_seconds = 5"));
  EXPECT_THAT(run_order(r.suite), ElementsAre(2U, 3U, 1U, 0U));
  std::vector<std::string> run;
  GradeRequest told = r;
  told.progress = [&](const std::string& what) { run.push_back(what); };
  EXPECT_THAT(outcomes(grade(told)), ElementsAre("a: pass", "b: pass", "c: pass", "d: pass"))
      << "results keep the suite's order";
  EXPECT_THAT(run, ElementsAre("c", "d", "b", "a"));
}

TEST_F(GradeRulesTest, AFilterKeepsWhatTheChosenCasesRequire) {
  GradeRequest r = request(suite() + a_case("a") + a_case("b", "requires = [\"a\"]") +
                           a_case("c", "requires = [\"b\"]") + a_case("d"));
  r.filter = "[c]*";
  EXPECT_THAT(outcomes(grade(r)), ElementsAre("a: pass", "b: pass", "c: pass"));
  r.filter = "d";
  const ResultSet results = grade(r);
  EXPECT_THAT(outcomes(results), ElementsAre("d: pass"));
  EXPECT_EQ(results.totals().max_points, 10);
  r.filter = "e*";
  EXPECT_THROW(grade(r), InputError);
}

TEST_F(GradeRulesTest, RequestsThatCannotBeGradedAreRefused) {
  const GradeRequest good = request(suite() + a_case("a"));
  const auto expect_refused = [&](const auto& change, const char* why) {
    GradeRequest bad = good;
    change(bad);
    try {
      grade(bad);
      FAIL() << "graded, though " << why;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(why));
    }
  };
  write("file", "");
  write("notes/mine.txt", "");
  fs::create_directory(folder_ / "sub/refs");
  fs::copy_file(folder_ / "ref.png", folder_ / "sub/refs/ref.png");
  fs::create_directory_symlink(folder_ / "sub/refs", folder_ / "linked");
  write("damaged.png", "no picture");
  expect_refused([&](GradeRequest& r) { r.submission = folder_ / "gone"; }, "the submission is no folder");
  expect_refused([&](GradeRequest& r) { r.submission = folder_ / "file"; }, "the submission is no folder");
  expect_refused([&](GradeRequest& r) { r.out = folder_ / "sub/out"; }, "would lie inside the submission");
  expect_refused([&](GradeRequest& r) { r.out = folder_ / "linked/out"; }, "would lie inside the submission");
  expect_refused([&](GradeRequest& r) { r.out = folder_; }, "the submission lies inside the folder for the results");
  expect_refused([&](GradeRequest& r) { r.out = folder_ / "notes"; }, "no result set and would be lost");
  expect_refused([&](GradeRequest& r) { r.out = folder_ / "file"; }, "no result set and would be lost");
  expect_refused([&](GradeRequest& r) { r.out = folder_ / "file/out"; }, "");
  expect_refused([&](GradeRequest& r) { r.suite.cases[0].reference = folder_ / "sub/refs/ref.png"; },
                 "lies inside the submission");
  expect_refused([&](GradeRequest& r) { r.suite.cases[0].reference = folder_ / "linked/ref.png"; },
                 "lies inside the submission");
  expect_refused([&](GradeRequest& r) { r.suite.cases[0].reference = folder_ / "damaged.png"; },
                 "the reference picture cannot be used");
  expect_refused([&](GradeRequest& r) { r.suite.runner.render[0] = "no-such-program"; },
                 "'no-such-program', which [runner] needs, is not installed");
  expect_refused([&](GradeRequest& r) { r.suite.runner.build = {{"no-such-compiler"}}; }, "is not installed");
  EXPECT_TRUE(fs::exists(folder_ / "notes/mine.txt"));
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

}  // namespace
}  // namespace plumb
