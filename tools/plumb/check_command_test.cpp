// `plumb check`, run as a program.
#include <algorithm>
#include <array>
#include <set>

#include "tools/plumb/program_for_tests.h"

namespace plumb {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::Pair;

class CheckCommandTest : public ProgramTest {
 protected:
  static inline const std::string kOwnProbe = "'" PLUMB_PROGRAM "' probe";
  /// Our own probe, spoiled where it is asked `ask`.
  static std::string spoiled_probe(const std::string& way, const std::string& ask) {
    return "--probe '" PLUMB_TEST_SUBJECTS "/spoiling_probe' " + way + " " + ask + " " + kOwnProbe;
  }
};

TEST_F(CheckCommandTest, OurOwnTracerPassesEveryCheck) {
  EXPECT_EQ(plumb("check plumb --intensity 0.001 --json"), 0) << complained_;
  const json results = json::parse(said_);
  EXPECT_EQ(results["submission"], "plumb");
  EXPECT_EQ(results["suite"]["id"], "checks");
  EXPECT_EQ(results["totals"]["points"], results["totals"]["max_points"]);
  const auto found = verdicts(results);
  EXPECT_GE(found.size(), 42u);
  for (const auto& [id, verdict] : found) EXPECT_EQ(verdict, "pass") << id;
  EXPECT_EQ(complained_, "");
}

TEST_F(CheckCommandTest, TheListSaysWhatIsAskedAndOfWhom) {
  EXPECT_EQ(plumb("check --list"), 0) << complained_;
  for (const char* word : {"T1 ", "average-position", "asks: ", "matters: ", "tolerance: ", "shipped subjects: plumb",
                           "mt-float", "woop-float", "embree-robust"})
    EXPECT_THAT(said_, HasSubstr(word));
  EXPECT_EQ(plumb("check plumb --intensity 0.001 --filter N1,F1 --json"), 0);
  EXPECT_THAT(said_verdicts(), ElementsAre(Pair("F1", "pass"), Pair("N1", "pass")));
}

TEST_F(CheckCommandTest, SubjectsAreGivenByNameByLibraryOrByCommand) {
  EXPECT_EQ(plumb("check mt-float --intensity 0.001 --filter T0"), 0) << complained_;
  EXPECT_THAT(said_, AllOf(HasSubstr("not isolated"), HasSubstr("mt-float: Moller-Trumbore in single precision"),
                           HasSubstr("contract: float in, float t"), HasSubstr("T0    pass"), Not(HasSubstr("\x1b["))));
  EXPECT_EQ(plumb("check '" PLUMB_TEST_SUBJECTS "/overflowing_kernel.so' --intensity 0.001 --filter T0,S0"), 1);
  EXPECT_THAT(said_, AllOf(HasSubstr("T0    pass"), HasSubstr("S0    unsupported")));
  EXPECT_EQ(plumb("check --intensity 0.02 --filter N1,bounds --json --probe " + kOwnProbe), 0) << complained_;
  EXPECT_THAT(said_verdicts(), ElementsAre(Pair("N1", "pass"), Pair("bounds", "pass")));
}

TEST_F(CheckCommandTest, TheSameSeedGivesTheSameResultsToTheByte) {
  const std::string words = "check mt-float --intensity 0.02 --filter 'T*' --json --seed ";
  EXPECT_EQ(plumb(words + "5"), 1);
  const std::string first = said_;
  plumb(words + "5");
  EXPECT_EQ(said_, first);
  plumb(words + "6");
  EXPECT_NE(said_, first);
}

TEST_F(CheckCommandTest, OutStoresAResultSet) {
  EXPECT_EQ(plumb("check mt-float --intensity 0.02 --filter T0,T8 --seed 3 --out out"), 1);
  EXPECT_THAT(said_, HasSubstr("Results: out"));
  const json results = json::parse(content("out/results.json"));
  EXPECT_EQ(results["totals"]["points"], 1);
  EXPECT_EQ(results["totals"]["max_points"], 2);
  const json one = json::parse(content("out/cases/T8/case.json"));
  EXPECT_EQ(one["verdict"], "fail");
  EXPECT_EQ(one["cause"], "class");
  EXPECT_EQ(one["seed"], 3);
  EXPECT_EQ(one["repeat"], "plumb check mt-float --filter T8 --seed 3 --intensity 0.02");
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/cases/T0/usage.json"));
  // What the worst case names can be asked, and says that the check was right.
  const std::string explained = one["evidence"]["worst_explained_by"];
  EXPECT_THAT(explained, testing::StartsWith("plumb oracle ray --triangle "));
  EXPECT_EQ(plumb(explained.substr(6)), 0) << complained_;
  const std::string truth = one["evidence"]["worst_truth"];
  EXPECT_THAT(said_, HasSubstr("answer: " + truth.substr(0, truth.find(' '))));
}

TEST_F(CheckCommandTest, MistakesInTheCommandAreStatusTwo) {
  const std::array<std::array<const char*, 2>, 10> mistakes{
      {{"check", "nothing to check, expected plumb, a shipped kernel, a .so, a folder with --suite, or --probe"},
       {"check mt-flot", "did you mean 'mt-float'?"},
       {"check plumb --filter T99", "--filter: no check matches 'T99'; did you mean 'T9'?"},
       {"check plumb --filter T1,", "no check matches ''"},
       {"check missing.so", "the library cannot be loaded"},
       {"check .", "is a folder, expected --suite SUITE.toml"},
       {"check plumb --intensity 0", "--intensity"},
       {"check plumb --seed x", "--seed"},
       {"check plumb --probe x", "both a subject ('plumb') and --probe are given"},
       {"check mt-float --filter T0 --intensity 0.001 --out said.txt", "said.txt"}}};
  for (const auto& [words, message] : mistakes) {
    EXPECT_EQ(plumb(words), 2) << words;
    EXPECT_THAT(complained_, HasSubstr(message)) << words;
  }
}

TEST_F(CheckCommandTest, ASubjectThatFailsAsItStartsHasThatVerdictInAllChecks) {
  EXPECT_EQ(plumb("check --filter T0,N1 --json --probe /no/such/program"), 1);
  EXPECT_THAT(said_verdicts(), ElementsAre(Pair("N1", "fail (cannot_start)"), Pair("T0", "fail (cannot_start)")));
  EXPECT_EQ(plumb("check --filter T0 --json --probe /bin/echo hello"), 1);
  EXPECT_THAT(said_verdicts(), ElementsAre(Pair("T0", "fail (protocol)"))) << "no greeting";
  EXPECT_EQ(plumb("check '" PLUMB_TEST_SUBJECTS "/wrong_kernel.so' --filter T0 --out out", "PLUMB_WRONG_KERNEL=crash"),
            1);
  EXPECT_THAT(verdicts(json::parse(content("out/results.json"))), ElementsAre(Pair("T0", "crash (signal)")));
  EXPECT_THAT(said_, HasSubstr("signal 11"));
}

/// T7 and T8 have coordinates that overflow the kernel's cells, T0, T1 and T5 have none.
TEST_F(CheckCommandTest, AKernelThatCrashesOrReturnsNaNLosesOnlyTheCheckWhereItDoes) {
  const std::string words = "check '" PLUMB_TEST_SUBJECTS
                            "/overflowing_kernel.so' --intensity 0.01 --json "
                            "--filter T0,T1,T5,T7";
  EXPECT_EQ(plumb(words, "PLUMB_OVERFLOWING_KERNEL=none"), 0) << said_;
  EXPECT_EQ(plumb(words, "PLUMB_OVERFLOWING_KERNEL=crash"), 1);
  EXPECT_THAT(said_verdicts(),
              ElementsAre(Pair("T0", "pass"), Pair("T1", "pass"), Pair("T5", "pass"), Pair("T7", "crash (signal)")));
  EXPECT_EQ(plumb(words, "PLUMB_OVERFLOWING_KERNEL=nan"), 1);
  EXPECT_THAT(said_verdicts(),
              ElementsAre(Pair("T0", "pass"), Pair("T1", "pass"), Pair("T5", "pass"), Pair("T7", "fail (not_finite)")));
  // The check that fails is not the last one.
  EXPECT_EQ(plumb("check '" PLUMB_TEST_SUBJECTS "/overflowing_kernel.so' --intensity 0.01 --json --filter T7,T9,T11",
                  "PLUMB_OVERFLOWING_KERNEL=crash"),
            1);
  EXPECT_THAT(said_verdicts(),
              ElementsAre(Pair("T11", "crash (signal)"), Pair("T7", "crash (signal)"), Pair("T9", "pass")));
}

TEST_F(CheckCommandTest, AProbeThatFailsLosesOnlyTheCheckWhereItDoes) {
  const std::array<std::array<const char*, 2>, 4> ways{{{"garbage", "fail (protocol)"},
                                                        {"half-line", "fail (protocol)"},
                                                        {"nan", "fail (not_finite)"},
                                                        {"crash", "crash (signal)"}}};
  for (const auto& [way, verdict] : ways) {
    EXPECT_EQ(plumb("check --intensity 0.001 --json --filter F1,M4,S0 " + spoiled_probe(way, "matrices")), 1) << way;
    EXPECT_THAT(said_verdicts(), ElementsAre(Pair("F1", "pass"), Pair("M4", verdict), Pair("S0", "pass")))
        << way << complained_;
  }
}

}  // namespace
}  // namespace plumb
