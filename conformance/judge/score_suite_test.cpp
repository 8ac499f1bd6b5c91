// The kill matrix of a suite that was made by hand: what notices what, and what becomes of claims that do not hold.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "conformance/judge/built_suite_for_tests.h"

namespace plumb {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class ScoreSuiteTest : public BuiltSuiteTest {
 protected:
  /// A mutant of pictures alone, and its row.
  ScoreRow row_of(const std::string& claim, std::map<std::string, StoredPicture> pictures,
                  std::vector<std::string> no_picture = {}) const {
    write_mutant("m", claim);
    if (!pictures.empty() || !no_picture.empty()) write_pictures("m", std::move(pictures), std::move(no_picture));
    const SuiteScore s = score("m");
    EXPECT_EQ(s.rows.size(), 1u);
    EXPECT_EQ(s.rows.at(0).missing.empty(), is_settled(s.rows.at(0).verdict));
    EXPECT_EQ(s.exit_status(), is_settled(s.rows.at(0).verdict) ? 0 : 1);
    return s.rows.at(0);
  }
  static std::vector<Notice> notices(const ScoreRow& row) {
    std::vector<Notice> found;
    for (const ScoreCell& cell : row.cells) found.push_back(cell.notice);
    return found;
  }
};

TEST_F(ScoreSuiteTest, CaughtByAllThatItNamesAndByOthers) {
  const ScoreRow row = row_of("caught_by = [\"a\", \"b\"]", {{"a", picture(100, 20)}, {"c", picture(90)}}, {"b"});
  EXPECT_EQ(row.verdict, MutantVerdict::caught);
  EXPECT_THAT(notices(row), ElementsAre(Notice::wrong, Notice::no_picture, Notice::wrong));
  EXPECT_EQ(row.cells[0].wrong_pixels, 20);
  EXPECT_TRUE(row.cells[0].named);
  EXPECT_FALSE(row.cells[2].named);
  EXPECT_EQ(row.cells[2].wrong_pixels, kWidth * kHeight);
}

TEST_F(ScoreSuiteTest, CaughtByPartOfWhatItNames) {
  const ScoreRow row = row_of("caught_by = [\"a\", \"b\"]", {{"a", picture(90)}});
  EXPECT_EQ(row.verdict, MutantVerdict::partly_caught);
  EXPECT_THAT(row.missing, ElementsAre("b: finds nothing wrong"));
}

TEST_F(ScoreSuiteTest, CaughtOnlyElsewhere) {
  const ScoreRow row = row_of("caught_by = [\"b\"]", {{"a", picture(90)}});
  EXPECT_EQ(row.verdict, MutantVerdict::elsewhere);
  EXPECT_THAT(row.missing, ElementsAre("b: finds nothing wrong"));
}

TEST_F(ScoreSuiteTest, WhatNothingNoticesSurvives) {
  const ScoreRow row = row_of("caught_by = [\"a\"]", {});
  EXPECT_EQ(row.verdict, MutantVerdict::survives);
  EXPECT_THAT(notices(row), ElementsAre(Notice::right, Notice::right, Notice::right));
}

/// Grading would let such pictures pass.
TEST_F(ScoreSuiteTest, AWarningIsNoNotice) {
  const ScoreRow row = row_of("caught_by = [\"a\"]", {{"a", picture(100, 2)}});
  EXPECT_EQ(row.verdict, MutantVerdict::survives);
  EXPECT_EQ(row.cells[0].notice, Notice::warning);
  EXPECT_EQ(row.cells[0].wrong_pixels, 2);
  ASSERT_EQ(row.missing.size(), 1u);
  EXPECT_THAT(row.missing[0], HasSubstr("isolated_pixels"));
}

TEST_F(ScoreSuiteTest, WhatAnotherVariantAcceptsIsNotNoticedByThatCaseAlone) {
  const ScoreRow row = row_of("caught_by = [\"c\"]", {{"c", picture(140)}});
  EXPECT_EQ(row.verdict, MutantVerdict::survives);
  EXPECT_EQ(row.cells[2].notice, Notice::by_variant);
  ASSERT_EQ(row.missing.size(), 1u);
  EXPECT_THAT(row.missing[0], HasSubstr("right by the variant 'up'"));
}

TEST_F(ScoreSuiteTest, ACaseThatTheSuiteLacks) {
  const ScoreRow row = row_of("caught_by = [\"a\", \"cone\"]", {{"a", picture(90)}});
  EXPECT_EQ(row.verdict, MutantVerdict::partly_caught);
  EXPECT_THAT(row.missing, ElementsAre("cone: the suite has no such case with an envelope"));
}

TEST_F(ScoreSuiteTest, AnAcceptedMutantIsGradedByItsVariant) {
  write_program("m", {100, 100, 140});
  const ScoreRow row = row_of("accepted = \"up\"", {{"c", picture(140)}});
  EXPECT_EQ(row.verdict, MutantVerdict::accepted);

  // The suite was built with the same picture, but now the program draws one that only the first variant accepts.
  write_program("m", {100, 100, 100});
  const ScoreRow other = row_of("accepted = \"up\"", {{"c", picture(140)}});
  EXPECT_EQ(other.verdict, MutantVerdict::not_accepted);
  ASSERT_EQ(other.missing.size(), 1u);
  EXPECT_THAT(other.missing[0], HasSubstr("c: is not right by the variant 'up': 48 of 48 pixels"));
  EXPECT_THAT(row_of("accepted = \"down\"", {}).missing, ElementsAre("the suite accepts no variant 'down'"));
}

TEST_F(ScoreSuiteTest, AnEquivalentMutantShowsNowhere) {
  EXPECT_EQ(row_of("equivalent = \"x is y\"", {}).verdict, MutantVerdict::equivalent);
  const ScoreRow row = row_of("equivalent = \"x is y\"", {{"b", picture(100, 1)}});
  EXPECT_EQ(row.verdict, MutantVerdict::not_equivalent);
  ASSERT_EQ(row.missing.size(), 1u);
  EXPECT_THAT(row.missing[0], HasSubstr("b: 1 of 48 pixels"));
}

TEST_F(ScoreSuiteTest, ChecksAreAskedOfTheMutantsThatNameThem) {
  write_program("crashes", {100, 100, 100}, kCrashesAtMatrices);
  write_program("passes", {100, 100, 100});
  write_mutant("crashes", "caught_by = [\"check:M4\"]");
  write_mutant("passes", "caught_by = [\"check:M4\", \"a\"]");
  write_pictures("passes", {{"a", picture(90)}});
  write_mutant("unasked", "caught_by = [\"a\"]");
  write_pictures("unasked", {{"a", picture(80)}});
  const SuiteScore s = score();
  ASSERT_EQ(s.columns.size(), 4u);
  EXPECT_EQ(s.columns[3].id, "check:M4");
  EXPECT_EQ(s.columns[3].noticed, 1);
  EXPECT_THAT(s.columns[3].only_here, IsEmpty()) << "a check is no case of the suite";
  ASSERT_EQ(s.rows.size(), 3u);
  EXPECT_EQ(s.rows[0].verdict, MutantVerdict::caught);
  EXPECT_EQ(s.rows[0].cells[3].notice, Notice::wrong);
  EXPECT_EQ(s.rows[1].verdict, MutantVerdict::partly_caught);
  EXPECT_THAT(s.rows[1].missing, ElementsAre("check:M4: finds nothing wrong"));
  EXPECT_EQ(s.rows[2].cells[3].notice, Notice::not_asked);
  EXPECT_EQ(s.exit_status(), 1);
}

TEST_F(ScoreSuiteTest, ACheckThatFailsOnTheTracerWithoutMistakesIsOurFault) {
  write_program("tracer", {100, 100, 100}, kCrashesAtMatrices);
  write_program("m", {100, 100, 100}, kCrashesAtMatrices);
  write_mutant("m", "caught_by = [\"check:M4\"]");
  const SuiteScore s = score();
  EXPECT_THAT(s.columns[3].fault, HasSubstr("signal"));
  EXPECT_EQ(s.columns[3].noticed, 0);
  EXPECT_EQ(s.rows[0].verdict, MutantVerdict::survives);
  EXPECT_THAT(s.rows[0].missing, ElementsAre("check:M4: is not right with the tracer without mistakes, either"));
  EXPECT_EQ(s.exit_status(), 3);
}

TEST_F(ScoreSuiteTest, ACaseThatTheTracerWithoutMistakesGetsWrongIsOurFault) {
  write_program("tracer", {100, 90, 100});
  write_mutant("m", "caught_by = [\"b\"]");
  write_pictures("m", {{"b", picture(90)}});
  const SuiteScore s = score();
  EXPECT_THAT(s.columns[1].fault, HasSubstr("48 of 48 pixels"));
  EXPECT_EQ(s.columns[0].fault, "");
  EXPECT_EQ(s.rows[0].verdict, MutantVerdict::survives);
  EXPECT_EQ(s.exit_status(), 3);
}

/// A growth case is run on the mutants that name it: here one that draws no picture, where the real tracer would.
TEST_F(ScoreSuiteTest, GrowthCasesAreRunOnTheMutantsThatNameThem) {
  fs::copy_file(fs::path(PLUMB_SOURCE_DIR) / "suites/growth/mesh.xml", folder_ / "built/mesh.xml");
  std::ofstream(folder_ / "built/suite.toml", std::ios::app)
      << "[[case]]\nid = \"growth\"\nkind = \"growth\"\nmeasure = \"trace\"\nscene = \"mesh.xml\"\nlargest = 64000\n";
  write_mutant("m", "caught_by = [\"growth\"]");
  write_program("m", {100, 100, 100});
  const SuiteScore s = score();
  ASSERT_EQ(s.columns.size(), 4u);
  EXPECT_EQ(s.columns[3].kind, "growth");
  EXPECT_EQ(s.rows[0].cells[3].notice, Notice::wrong);
  EXPECT_THAT(s.columns[3].fault, HasSubstr("no picture")) << "the tracer of this test draws none, either";
  write_mutant("m", "caught_by = [\"a\"]");
  EXPECT_EQ(score().columns[3].fault, "") << "not run where no mutant names it";
}

TEST_F(ScoreSuiteTest, SaysWhatACaseIsWorth) {
  write_mutant("one", "caught_by = [\"a\"]");
  write_pictures("one", {{"a", picture(90)}});
  write_mutant("two", "caught_by = [\"a\", \"b\"]");
  write_pictures("two", {{"a", picture(80)}, {"b", picture(80)}});
  const SuiteScore s = score();
  EXPECT_THAT(s.columns[0].only_here, ElementsAre("one"));
  EXPECT_EQ(s.columns[0].noticed, 2);
  EXPECT_THAT(s.columns[1].only_here, IsEmpty());
  EXPECT_EQ(s.columns[1].noticed, 1);
  EXPECT_EQ(s.columns[2].noticed, 0);
  EXPECT_EQ(s.count(MutantVerdict::caught), 2);
  EXPECT_EQ(s.to_catch(), 2);
  EXPECT_EQ(s.exit_status(), 0);
}

TEST_F(ScoreSuiteTest, PairsOfMistakesAreNoMutants) {
  write_mutant("one", "caught_by = [\"a\"]");
  Fingerprint pair;
  pair.id = "one", pair.parts = {"x", "y"};
  pair.pictures.emplace("a", picture(90));
  write_fingerprint(pair, folder_ / "built/fingerprints/one");
  EXPECT_EQ(score().rows[0].verdict, MutantVerdict::survives);
}

TEST_F(ScoreSuiteTest, RefusesWhatCannotBeMeasured) {
  const auto complaint = [&](const SuiteScoreRequest& r) -> std::string {
    try {
      score_suite(r);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  write_mutant("m", "caught_by = [\"check:M4\"]");
  EXPECT_THAT(complaint(request("n*")), HasSubstr("no known mistake matches 'n*'"));
  EXPECT_THAT(complaint(request()), HasSubstr("mutants/m: this program with a known mistake does not exist"));
  write("built/suite.toml",
        "[suite]\nid = \"s\"\nschema = 1\nown_runner = true\n[[case]]\nid = \"a\"\nscene = \"a.txt\"\n");
  EXPECT_THAT(complaint(request()), HasSubstr("holds no pictures of known mistakes"));
}

}  // namespace
}  // namespace plumb
