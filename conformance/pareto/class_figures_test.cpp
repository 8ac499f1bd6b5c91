#include "conformance/pareto/class_figures.h"

#include <gtest/gtest.h>

#include "conformance/checks/class_question.h"
#include "conformance/pareto/tolerant_kernel.h"
#include "conformance/subject/shipped_kernels.h"

namespace plumb {
namespace {

Contender contender_of(const std::string& name, plumb_precision inputs) {
  Contender contender{name, inputs, nullptr, {}};
  contender.subject = std::make_unique<TolerantKernel>(shipped_kernel(name), contender.not_finite);
  return contender;
}

const ClassQuestion& question_of(std::string_view family) {
  for (const ClassQuestion& question : triangle_questions())
    if (question.family == family) return question;
  throw std::logic_error("no such question");
}

/// The triangle (0,0) (8,0) (0,8) in the plane z = 0, and rays from above: at its inside, past it, at its hypotenuse.
FamilyCase three_rays() {
  FamilyCase one;
  one.surface.shape.vertices = {Point3{0, 0, 0}, Point3{8, 0, 0}, Point3{0, 8, 0}};
  one.rays = {{{1, 1, 2}, {0, 0, -1}}, {{7, 7, 2}, {0, 0, -1}}, {{4, 4, 2}, {0, 0, -1}}};
  return one;
}

SubjectHit hit_at(double t) {
  SubjectHit hit;
  hit.surface = 0;
  hit.t = t;
  return hit;
}

ClassFigure judged(const std::vector<SubjectHit>& answers) {
  const FamilyCase one = three_rays();
  CaseTruth truth(one);
  Contract contract;
  contract.precision = contract.t_precision = PLUMB_FLOAT;
  ClassTally tally(question_of("T0"), contract);
  tally.judge(one, truth, answers);
  return std::move(tally).figure();
}

TEST(ClassTally, RightAnswersAreNotWrongAndABoundaryIsFree) {
  for (const bool boundary_hit : {false, true}) {
    const ClassFigure figure = judged({hit_at(2), {}, boundary_hit ? hit_at(2) : SubjectHit{}});
    EXPECT_EQ(figure.rays, 3);
    EXPECT_EQ(figure.wrong().count, 0);
    EXPECT_EQ(figure.right_hits, 1) << "a free one says nothing of t";
    EXPECT_EQ(figure.t_ulps_median, 0);
  }
}

TEST(ClassTally, CountsFalseMissesAndFalseHitsApart) {
  const ClassFigure figure = judged({{}, hit_at(2), {}});
  EXPECT_EQ(figure.false_misses, 1);
  EXPECT_EQ(figure.false_hits, 1);
  EXPECT_EQ(figure.wrong_crossings, 0);
  EXPECT_EQ(figure.wrong(), (Rate{2, 3}));
  // U = 48 of the ray at (7,7), over |d|_1 = 1, s = 7, e = 8 and 2^-24.
  EXPECT_EQ(figure.farthest_u, 48.0 / 56 * 0x1p24);
}

TEST(ClassTally, TIsOffInUlpsOfTheKernel) {
  const ClassFigure figure = judged({hit_at(2 + 3 * 0x1p-22), {}, {}});
  EXPECT_EQ(figure.wrong().count, 0);
  EXPECT_EQ(figure.t_ulps_p99, 3);
}

/// The table's figures are those of `plumb check` for the same seed and count.
TEST(ClassFigures, AreThoseOfTheCheck) {
  constexpr std::int64_t kCount = 3000;
  for (const char* family : {"T0", "T1", "T5"}) {
    Contender contender = contender_of("mt-float", PLUMB_FLOAT);
    const ClassCounts counts = ask_family(*contender.subject, family_kind(family), 7, kCount);
    Contender* const asked[] = {&contender};
    const ClassFigure figure = class_figures(asked, question_of(family), 7, kCount, [](double) {}).at(0);
    EXPECT_EQ(figure.rays, counts.rays);
    EXPECT_GE(figure.rays, kCount);
    EXPECT_EQ(figure.false_misses, counts.false_misses);
    EXPECT_EQ(figure.false_hits, counts.false_hits);
    EXPECT_EQ(figure.false_hits > 0, std::string_view(family) != "T0");
    // T0 is of condition 1, by which the check divides.
    EXPECT_TRUE(figure.t_ulps_p99 == counts.t_percentile(0.99) || std::string_view(family) != "T0");
  }
}

TEST(ClassFigures, AKernelOfDoublesIsRightOnFloatsAndNotOnDoubles) {
  for (const plumb_precision inputs : {PLUMB_FLOAT, PLUMB_DOUBLE}) {
    Contender contender = contender_of("mt-double", inputs);
    Contender* const asked[] = {&contender};
    const ClassFigure figure = class_figures(asked, question_of("T1"), 1, 3000, [](double) {}).at(0);
    EXPECT_GE(figure.rays, 3000);
    EXPECT_EQ(figure.wrong().count > 0, inputs == PLUMB_DOUBLE) << figure.wrong().count;
  }
}

TEST(ClassFigures, HugeAndSmallArePartsOfOneFamily) {
  std::int64_t questions = 0;
  for (const ClassQuestion& question : triangle_questions()) {
    if (question.family != "T8") continue;
    ++questions;
    const auto source = family_kind("T8").make(1, PLUMB_FLOAT);
    std::int64_t included = 0;
    for (int i = 0; i < 200; ++i) included += question.includes(source->next(), Rounding(PLUMB_FLOAT));
    EXPECT_GT(included, 60) << question.name;
    EXPECT_LT(included, 140) << question.name;
  }
  EXPECT_EQ(questions, 2);
}

}  // namespace
}  // namespace plumb
