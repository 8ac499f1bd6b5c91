// Pictures by real students beside what they should have been.
#include <gtest/gtest.h>

#include <string>

#include "conformance/compare/flip.h"
#include "conformance/compare/judge_picture.h"
#include "conformance/compare/picture_faults.h"
#include "renderer/image/read_picture.h"

namespace plumb {
namespace {

std::string pair_start(const std::string& name) { return PLUMB_SHARED_DIR "/flip/" + name; }

class FlipPairTest : public testing::TestWithParam<const char*> {};

TEST_P(FlipPairTest, IsCalledDifferent) {
  const std::string start = pair_start(GetParam());
  const Picture reference = read_reference(start + ".reference.png");
  for (const double tolerance : {0.0, 1.0}) {
    const PictureJudgement judged = judge_picture(start + ".test.png", reference, tolerance);
    EXPECT_EQ(judged.result.verdict, Verdict::fail);
    EXPECT_EQ(judged.result.cause, "different");
    ASSERT_TRUE(judged.difference);
    EXPECT_GT(judged.difference->pixels_past, 0);
  }
  EXPECT_EQ(judge_picture(start + ".reference.png", reference, 0).result.verdict, Verdict::pass);
}

INSTANTIATE_TEST_SUITE_P(Flip, FlipPairTest,
                         testing::Values("bunny500_norms", "glazed-ball", "solids", "sphereSquished"));

TEST(FlipPairs, MeanAndMaximumAreThoseOfTheAuthorsTool) {
  // Version 1.6, 67 pixels a degree; from the README beside the pictures.
  const struct {
    const char* name;
    double mean, max;
  } table[] = {{"glazed-ball", 0.005659, 0.895323},
               {"sphereSquished", 0.037760, 0.964883},
               {"bunny500_norms", 0.016245, 0.466665},
               {"solids", 0.497180, 0.992082}};
  for (const auto& row : table) {
    const std::string start = pair_start(row.name);
    const FlipErrors errors = flip(read_picture(start + ".reference.png"), read_picture(start + ".test.png"));
    EXPECT_NEAR(errors.mean, row.mean, 1e-4) << row.name;
    EXPECT_NEAR(errors.max, row.max, 1e-4) << row.name;
    EXPECT_GT(errors.p99, errors.mean) << row.name;
  }
}

TEST(FlipPairs, OnlyTheHalfPixelIsASimpleFault) {
  const auto faults_of = [](const char* name) {
    const std::string start = pair_start(name);
    return picture_faults(read_picture(start + ".reference.png"), read_picture(start + ".test.png"), 1);
  };
  const auto found = faults_of("bunny500_norms");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].fault, PictureFault::half_pixel_shift);
  for (const char* name : {"glazed-ball", "solids", "sphereSquished"}) EXPECT_TRUE(faults_of(name).empty()) << name;
}

}  // namespace
}  // namespace plumb
