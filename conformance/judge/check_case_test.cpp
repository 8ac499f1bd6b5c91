// Cases of kind `check`: a submission that answers by a kernel or a probe, and what becomes of one that fails at it.

#include "conformance/judge/grade_rules_fixture.h"

namespace plumb {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

class CheckCaseTest : public GradeRulesTest {
 protected:
  CheckCaseTest() {
    // Right but for coordinates past a million, as the variable says.
    fs::copy_file(fs::path(PLUMB_TEST_SUBJECTS) / "overflowing_kernel.so", folder_ / "sub/kernel.so");
    fs::copy_file(fs::path(PLUMB_TEST_SUBJECTS) / "no_kernel.so", folder_ / "sub/none.so");
    ::setenv(kWay, "none", 1);
  }
  ~CheckCaseTest() override { ::unsetenv(kWay); }

  static std::string a_check(const std::string& id, const std::string& filter, const std::string& keys = "") {
    return "[[case]]\nid = \"" + id + "\"\nkind = \"check\"\nintensity = 0.003\npoints = 10\nfilter = \"" + filter +
           "\"\n" + keys + "\n";
  }
  /// Our own probe, spoiled where it is asked `ask`.
  static std::string probe(const std::string& way, const std::string& ask) {
    return "probe = [\"" PLUMB_TEST_SUBJECTS "/spoiling_probe\", \"" + way + "\", \"" + ask +
           "\", \"" PLUMB_PROGRAM "\", \"probe\"]";
  }
  /// What reading a suite complains of.
  std::string complaint(const std::string& text) const {
    write("suite.toml", text);
    try {
      read_suite(folder_ / "suite.toml");
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  static constexpr const char* kWay = "PLUMB_OVERFLOWING_KERNEL";
  static inline const std::string kKernel = "kernel = \"kernel.so\"";
};

TEST_F(CheckCaseTest, AKernelPassesFailsOrLacksIt) {
  const ResultSet results =
      grade_by(suite("", kKernel) + a_check("right", "T0,T1") + a_check("balls", "S0") + a_check("huge", "T8") +
               a_check("mixed", "T0,T8") + a_check("after", "T0", "requires = [\"huge\"]"));
  EXPECT_THAT(outcomes(results), ElementsAre("right: pass", "balls: unsupported (unsupported)", "huge: fail (class)",
                                             "mixed: fail (class)", "after: skipped (prerequisite)"));
  EXPECT_EQ(results.totals().points, 10);
  EXPECT_EQ(results.totals().max_points, 50);
  EXPECT_EQ(results.cases[0].kind, "check");
  EXPECT_EQ(results.cases[0].seed, 1u);
  EXPECT_THAT(results.cases[0].check.summary, HasSubstr("2 of 2 checks are right"));
  EXPECT_THAT(results.cases[3].check.summary, AllOf(HasSubstr("1 of 2 checks are right"), HasSubstr("T8: ")));
  // What each check found, and its verdict.
  const Evidence& evidence = results.cases[3].check.evidence;
  ASSERT_EQ(evidence.size(), 4u);
  EXPECT_EQ(evidence[0], std::make_pair(std::string("T0"), EvidenceValue(std::string("pass"))));
  EXPECT_EQ(evidence[2], std::make_pair(std::string("T8"), EvidenceValue(std::string("fail"))));
}

TEST_F(CheckCaseTest, TheSameSuiteFindsTheSame) {
  const std::string text = suite("", kKernel) + a_check("a", "T1", "seed = 5") + a_check("b", "T1", "seed = 6");
  const ResultSet first = grade_by(text), second = grade_by(text);
  EXPECT_EQ(first.cases[0].check.summary, second.cases[0].check.summary);
  EXPECT_EQ(first.cases[0].check.evidence, second.cases[0].check.evidence);
  EXPECT_NE(first.cases[0].check.evidence, first.cases[1].check.evidence);
}

TEST_F(CheckCaseTest, AKernelThatFailsLosesOnlyTheCaseWhereItDoes) {
  // Only the one that hangs is to meet its limit, also where sanitizers make all slow.
  const auto graded = [&](const char* way, const char* limit = "") {
    ::setenv(kWay, way, 1);
    return outcomes(
        grade_by(suite("", kKernel) + a_check("before", "T0") + a_check("far", "T7", limit) + a_check("after", "T1")));
  };
  EXPECT_THAT(graded("none"), ElementsAre("before: pass", "far: pass", "after: pass"));
  EXPECT_THAT(graded("crash"), ElementsAre("before: pass", "far: crash (signal)", "after: pass"));
  EXPECT_THAT(graded("nan"), ElementsAre("before: pass", "far: fail (not_finite)", "after: pass"));
  EXPECT_THAT(graded("hang", "wall_seconds = 1"),
              ElementsAre("before: pass", "far: timeout (wall_time)", "after: pass"));
}

TEST_F(CheckCaseTest, AProbeThatFailsLosesOnlyTheCaseWhereItDoes) {
  const std::string cases = a_check("frames", "N1", "cpu_seconds = 20\nwall_seconds = 60") + a_check("optics", "F1");
  const auto graded = [&](const char* way) { return outcomes(grade_by(suite("", probe(way, "frame")) + cases)); };
  EXPECT_THAT(graded("garbage"), ElementsAre("frames: fail (protocol)", "optics: pass"));
  EXPECT_THAT(graded("half-line"), ElementsAre("frames: fail (protocol)", "optics: pass"));
  EXPECT_THAT(graded("nan"), ElementsAre("frames: fail (not_finite)", "optics: pass"));
  EXPECT_THAT(graded("crash"), ElementsAre("frames: crash (signal)", "optics: pass"));
}

TEST_F(CheckCaseTest, AProbeThatDoesNotAnswerIsStoppedByTheCasesLimits) {
  const std::string cases = a_check("frames", "N1", "cpu_seconds = 1\nwall_seconds = 1.5") + a_check("optics", "F1");
  const auto graded = [&](const char* way) { return outcomes(grade_by(suite("", probe(way, "frame")) + cases)); };
  EXPECT_THAT(graded("hang"), ElementsAre("frames: timeout (wall_time)", "optics: pass"));
}

TEST_F(CheckCaseTest, AProbeThatBurnsTimeIsStoppedByTheCasesLimits) {
  const std::string one = a_check("frames", "N1", "cpu_seconds = 0.5\nwall_seconds = 30");
  EXPECT_THAT(outcomes(grade_by(suite("", probe("burn", "frame")) + one)), ElementsAre("frames: timeout (cpu_time)"));
}

TEST_F(CheckCaseTest, WhatIsNoKernelOrProbeIsTheSubmissionsFault) {
  const std::string one = a_check("a", "T0");
  EXPECT_THAT(outcomes(grade_by(suite("", "kernel = \"none.so\"") + one)), ElementsAre("a: fail (protocol)"));
  EXPECT_THAT(outcomes(grade_by(suite("", "kernel = \"missing.so\"") + one)), ElementsAre("a: fail (protocol)"));
  EXPECT_THAT(outcomes(grade_by(suite("", "probe = [\"./missing\"]") + one)), ElementsAre("a: fail (cannot_start)"));
  EXPECT_THAT(outcomes(grade_by(suite("", "probe = [\"/bin/sh\", \"-c\", \"echo hello\"]") + one)),
              ElementsAre("a: fail (protocol)"));
  // The submission says how it is asked, and does not.
  write("sub/submission.toml", "[runner]\nrender = [\"x\"]\n");
  const ResultSet results = grade_by(suite("own_runner = true", "") + one);
  EXPECT_THAT(outcomes(results), ElementsAre("a: fail (build)"));
  EXPECT_THAT(first_summary(results), HasSubstr("names neither a probe nor a kernel"));
  write("sub/submission.toml", "[runner]\nkernel = \"kernel.so\"\n");
  EXPECT_THAT(outcomes(grade_by(suite("own_runner = true", "") + one)), ElementsAre("a: pass"));
}

TEST_F(CheckCaseTest, MistakesOfTheSuiteAreNamedWithTheirLine) {
  const std::string head = suite("", kKernel);  // six lines
  EXPECT_THAT(complaint(head + a_check("a", "T99")),
              AllOf(HasSubstr("suite.toml:12:"), HasSubstr("no check matches 'T99'; did you mean 'T9'?")));
  EXPECT_THAT(complaint(head + a_check("a", "T0", "intensity2 = 1")), HasSubstr("intensity"));
  EXPECT_THAT(complaint(head + a_check("a", "T0", "scene = \"a.txt\"")), HasSubstr("scene"));
  EXPECT_THAT(complaint(head + a_check("a", "T0", "seed = -1")), AllOf(HasSubstr("suite.toml:"), HasSubstr("seed")));
  EXPECT_THAT(complaint(suite() + a_check("a", "T0")),
              AllOf(HasSubstr("suite.toml:"), HasSubstr("[runner] has neither 'probe' nor 'kernel'")));
  EXPECT_THAT(complaint(suite("", kKernel + "\nprobe = [\"x\"]") + a_check("a", "T0")),
              HasSubstr("'kernel' of [runner] stands beside 'probe'"));
  EXPECT_THAT(complaint(suite("", "kernel = \"../k.so\"") + a_check("a", "T0")), HasSubstr("stays inside the folder"));
  EXPECT_THAT(complaint(head + a_case("a")), HasSubstr("is image, but [runner] has no 'render'"));
}

}  // namespace
}  // namespace plumb
