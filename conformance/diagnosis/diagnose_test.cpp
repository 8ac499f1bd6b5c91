#include "conformance/diagnosis/diagnose.h"

#include <gmock/gmock.h>

#include "conformance/diagnosis/synthetic_cases_for_tests.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Not;

/// Mistakes that differ in place, amount, sign or kind.
std::vector<std::pair<std::string, Change>> known() {
  return {{"dark-corner", patch("a", 0, 0, 20, 20, -40)},
          {"bright-corner", patch("a", 0, 0, 20, 20, 40)},
          {"dark-everywhere", [](const std::string&, int, int) { return -25; }},
          {"band", sum(patch("b", 0, 10, 64, 16, 30), patch("c", 0, 10, 64, 16, 30))},
          {"band-in-one", patch("b", 0, 10, 64, 16, 30)},
          {"square", patch("c", 5, 25, 30, 45, -50)},
          {"slope", [](const std::string& id, int x, int) { return id == "d" ? x / 2 : 0; }},
          {"speckles", speckles(1, 3, "d", 0, 0, 64, 48, -60)}};
}

void add_known(SyntheticCases& cases) {
  for (const auto& [id, change] : known()) cases.add_mistake(id, change);
}

/// What another program does: a level here and there, and a few pixels of the edge.
int other_program(const std::string&, int x, int y) {
  if (x == kTestEdge) return scrambled(5, x, y) % 3 == 0 ? -30 : 0;
  return static_cast<int>(scrambled(9, x, y) % 3) - 1;
}

TEST(Diagnose, NamesEachMistakeAndIsConfident) {
  int named = 0;
  for (const auto& [id, change] : known()) {
    SyntheticCases cases(sum(change, other_program));
    add_known(cases);
    const Diagnosis diagnosis = cases.diagnosis();
    ASSERT_FALSE(diagnosis.suspicions.empty()) << id;
    EXPECT_EQ(diagnosis.suspicions[0].id, id);
    EXPECT_GT(diagnosis.suspicions[0].explained, 0.97) << id;
    EXPECT_LT(diagnosis.suspicions[0].missed, 0.03) << id;
    EXPECT_TRUE(diagnosis.confident) << id;
    EXPECT_THAT(diagnosis.suspicions[0].or_one_of, IsEmpty()) << id;
    ++named;
  }
  EXPECT_EQ(named, 8);
}

TEST(Diagnose, RightPicturesGiveNone) {
  for (const Change& change : {Change(no_change), Change(other_program)}) {
    SyntheticCases cases(change);
    add_known(cases);
    EXPECT_THAT(cases.diagnosis().suspicions, IsEmpty());
    EXPECT_FALSE(cases.diagnosis().confident);
  }
}

TEST(Diagnose, WhatNoKnownMistakeExplainsIsUnknown) {
  SyntheticCases cases(patch("a", 30, 30, 60, 46, 45));
  add_known(cases);
  EXPECT_THAT(cases.diagnosis().suspicions, IsEmpty());
}

TEST(Diagnose, ACaseInWhichTheMistakeWouldShowSpeaksAgainstIt) {
  SyntheticCases cases(patch("b", 0, 10, 64, 16, 30));
  cases.add_mistake("band", known()[3].second);
  const Diagnosis diagnosis = cases.diagnosis();
  ASSERT_EQ(diagnosis.suspicions.size(), 1u);
  EXPECT_EQ(diagnosis.suspicions[0].explained, 1);
  EXPECT_NEAR(diagnosis.suspicions[0].missed, 0.5, 1e-12);  // the half in case c
  EXPECT_FALSE(diagnosis.confident);
}

TEST(Diagnose, AMistakeThatShowsInPlacesIsSeenByWhatAgrees) {
  const Change everywhere = [](const std::string&, int, int) { return -30; };
  const Change in_places = sum(patch("a", 3, 5, 20, 15, -30), patch("c", 30, 0, 39, 48, -30));
  for (const bool known_to : {false, true}) {
    SyntheticCases cases(in_places);
    add_known(cases);
    cases.add_mistake("lost", everywhere);
    cases.fingerprints.back().in_places = known_to;
    const Diagnosis diagnosis = cases.diagnosis();
    EXPECT_EQ(!diagnosis.suspicions.empty() && diagnosis.suspicions[0].id == "lost", known_to);
    EXPECT_FALSE(diagnosis.confident);
  }
  // Where it agrees with half of what is wrong, another that agrees with all comes first.
  SyntheticCases cases(sum(patch("a", 0, 0, 20, 20, -40), patch("b", 0, 0, 20, 20, -30)));
  cases.add_mistake("lost", everywhere);
  cases.fingerprints.back().in_places = true;
  cases.add_mistake("corners", sum(patch("a", 0, 0, 20, 20, -40), patch("b", 0, 0, 20, 20, -30)));
  EXPECT_EQ(cases.diagnosis().suspicions.at(0).id, "corners");
}

TEST(Diagnose, ACaseWithoutAPictureSaysNothing) {
  SyntheticCases cases(patch("b", 0, 10, 64, 16, 30));
  cases.add_mistake("band", known()[3].second);
  cases.cases[2].levels = {};
  EXPECT_EQ(cases.diagnosis().suspicions.at(0).missed, 0);
  EXPECT_TRUE(cases.diagnosis().confident);

  SyntheticCases other(patch("b", 0, 10, 64, 16, 30));
  other.add_mistake("band", known()[4].second);
  other.fingerprints[0].no_picture = {"c"};
  EXPECT_TRUE(other.diagnosis().confident);
}

TEST(Diagnose, ASmallCaseIsNotDrownedByALargeOne) {
  // Both explain nearly all of the wrong area; only one has the small square in another case.
  const Change large = [](const std::string& id, int, int) { return id == "d" ? -25 : 0; };
  SyntheticCases cases(sum(large, patch("a", 0, 0, 12, 12, -40)));
  cases.add_mistake("large", large);
  cases.add_mistake("large-and-small", sum(large, patch("a", 0, 0, 12, 12, -40)));
  const Diagnosis diagnosis = cases.diagnosis();
  EXPECT_EQ(diagnosis.suspicions.at(0).id, "large-and-small");
  EXPECT_TRUE(diagnosis.confident);
}

TEST(Diagnose, AnotherConstantIsRankedFirstButNotConfident) {
  SyntheticCases cases(patch("a", 0, 0, 20, 20, -22));
  add_known(cases);
  const Diagnosis diagnosis = cases.diagnosis();
  ASSERT_FALSE(diagnosis.suspicions.empty());
  EXPECT_EQ(diagnosis.suspicions[0].id, "dark-corner");
  EXPECT_EQ(diagnosis.suspicions[0].explained, 0);
  EXPECT_FALSE(diagnosis.confident);
}

TEST(Diagnose, OtherNoiseOfTheSameKindIsRankedFirst) {
  SyntheticCases cases(speckles(2, 3, "d", 0, 0, 64, 48, -60));
  add_known(cases);
  const Diagnosis diagnosis = cases.diagnosis();
  ASSERT_FALSE(diagnosis.suspicions.empty());
  EXPECT_EQ(diagnosis.suspicions[0].id, "speckles");
}

TEST(Diagnose, TwoMistakesThatNobodyDrewTogetherAreBothNamed) {
  int pairs = 0;
  const auto mistakes = known();
  for (std::size_t i : {0u, 3u, 5u})
    for (std::size_t k : {3u, 5u, 6u}) {
      if (k <= i) continue;
      SyntheticCases cases(sum(sum(mistakes[i].second, mistakes[k].second), other_program));
      add_known(cases);
      const Diagnosis diagnosis = cases.diagnosis();
      ASSERT_FALSE(diagnosis.suspicions.empty());
      std::vector<std::string> both{mistakes[i].first, mistakes[k].first};
      std::ranges::sort(both);
      EXPECT_EQ(diagnosis.suspicions[0].parts, both);
      ++pairs;
    }
  EXPECT_EQ(pairs, 6);
}

TEST(Diagnose, ANamedPairIsKnownWhereItsPartsHideEachOther) {
  // Where both show, the pair's colour is not that of either.
  const Change a = patch("a", 0, 0, 40, 40, -40), b = patch("a", 10, 5, 39, 45, 70);
  SyntheticCases cases(sum(a, b));
  cases.add_mistake("a", a);
  cases.add_mistake("b", b);
  cases.add_mistake("a+b", sum(a, b), {"a", "b"});
  const Diagnosis diagnosis = cases.diagnosis();
  EXPECT_THAT(diagnosis.suspicions.at(0).parts, ElementsAre("a", "b"));
  EXPECT_GT(diagnosis.suspicions[0].explained, 0.97);
  EXPECT_TRUE(diagnosis.confident);
}

/// The change, and all of it mirrored: nothing is where it should be.
Change mirrored(Change change) {
  return [change = std::move(change)](const std::string& id, int x, int y) {
    const int from = kTestWidth - 1 - x;
    return test_level(id, from, y, 0) + change(id, from, y) - test_level(id, x, y, 0);
  };
}

/// A library in which `mirrored` is known to change every picture.
void add_mirrored(SyntheticCases& cases) {
  cases.add_mistake("mirrored", mirrored(no_change));
  PictureChange& change = cases.fingerprints.back().change.emplace();
  change.move = PictureChange::Move::left_right;
  for (std::size_t i = 0; i < 256; ++i) change.table[i] = static_cast<std::uint8_t>(i);
}

TEST(Diagnose, AMistakeIsSeenUnderOneThatChangesEveryPicture) {
  int seen = 0;
  for (const auto& [id, change] : known()) {
    if (id == "dark-everywhere" || id == "slope") continue;  // mirrored, too, all of the picture in a case
    SyntheticCases cases(mirrored(sum(change, other_program)));
    add_known(cases);
    add_mirrored(cases);
    const Diagnosis diagnosis = cases.diagnosis();
    ASSERT_FALSE(diagnosis.suspicions.empty()) << id;
    std::vector<std::string> both{id, "mirrored"};
    std::ranges::sort(both);
    EXPECT_EQ(diagnosis.suspicions[0].parts, both) << id;
    ASSERT_FALSE(diagnosis.suspicions[0].pixels.empty());
    for (const DiagnosisPixel& p : diagnosis.suspicions[0].pixels)
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(p.suspected[k], p.found[k], 2 + std::abs(p.found[k] - p.expected[k]) / 16);
    ++seen;
  }
  EXPECT_EQ(seen, 6);
}

TEST(Diagnose, NothingIsSeenUnderAPictureThatIsOnlyMirrored) {
  SyntheticCases cases(mirrored(other_program));
  add_known(cases);
  add_mirrored(cases);
  const Diagnosis diagnosis = cases.diagnosis();
  EXPECT_EQ(diagnosis.suspicions.at(0).id, "mirrored");
  EXPECT_TRUE(diagnosis.confident);
}

TEST(Diagnose, MistakesThatDrawTheSameAreNamedTogether) {
  SyntheticCases cases(known()[0].second);
  add_known(cases);
  cases.add_mistake("twin", known()[0].second);
  const Diagnosis diagnosis = cases.diagnosis();
  EXPECT_EQ(diagnosis.suspicions.at(0).id, "dark-corner");
  EXPECT_THAT(diagnosis.suspicions[0].or_one_of, ElementsAre("twin"));
  EXPECT_TRUE(diagnosis.confident);
}

TEST(Diagnose, MistakesThatDrawNearlyTheSameAreNotConfident) {
  SyntheticCases cases(patch("a", 0, 0, 20, 20, -40));
  cases.add_mistake("shorter", patch("a", 0, 0, 20, 19, -40));
  cases.add_mistake("longer", patch("a", 0, 0, 20, 22, -40));
  const Diagnosis diagnosis = cases.diagnosis();
  EXPECT_EQ(diagnosis.suspicions.size(), 2u);
  EXPECT_FALSE(diagnosis.confident);
}

TEST(Diagnose, ShowsPixelsThatTell) {
  SyntheticCases cases(known()[3].second);
  add_known(cases);
  const Diagnosis diagnosis = cases.diagnosis();
  const std::vector<DiagnosisPixel>& pixels = diagnosis.suspicions.at(0).pixels;
  ASSERT_EQ(pixels.size(), 2u);
  EXPECT_THAT(std::vector({pixels[0].case_id, pixels[1].case_id}), ::testing::UnorderedElementsAre("b", "c"));
  for (const DiagnosisPixel& p : pixels) {
    EXPECT_TRUE(p.y > 10 && p.y < 15) << p.y;  // within the band, not at its border
    EXPECT_EQ(p.expected[0], test_level(p.case_id, p.x, p.y, 0));
    EXPECT_EQ(p.found[0], p.expected[0] + 30);
    EXPECT_EQ(p.suspected, p.found);
  }
}

TEST(Diagnose, FindingsFromElsewhereAreRankedWithTheRest) {
  SyntheticCases cases(patch("a", 0, 0, 20, 20, -22));
  add_known(cases);
  Suspicion mirrored;
  mirrored.id = "mirrored", mirrored.likeness = mirrored.explained = 0.99;
  const std::vector<Suspicion> findings{mirrored};
  const Diagnosis diagnosis = diagnose(cases.cases, cases.fingerprints, findings);
  EXPECT_EQ(diagnosis.suspicions.at(0).id, "mirrored");
  EXPECT_EQ(diagnosis.suspicions.at(1).id, "dark-corner");
  EXPECT_TRUE(diagnosis.confident);
}

TEST(Diagnose, RefusesPicturesOfAnotherSize) {
  SyntheticCases cases(known()[0].second);
  add_known(cases);
  cases.fingerprints[0].pictures.at("a") = StoredPicture(Levels(3 * 4 * 4), 4, 4);
  EXPECT_THROW(cases.diagnosis(), InputError);
  cases.cases[1].levels = cases.cases[1].levels.first(3);
  EXPECT_THROW(cases.diagnosis(), std::invalid_argument);
}

}  // namespace
}  // namespace plumb
