// Pictures by real students beside what they should have been.
#include <gtest/gtest.h>

#include <string>

#include "conformance/compare/judge_picture.h"

namespace plumb {
namespace {

class FlipPairTest : public testing::TestWithParam<const char*> {};

TEST_P(FlipPairTest, IsCalledDifferent) {
  const std::string start = std::string(PLUMB_SHARED_DIR "/flip/") + GetParam();
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

}  // namespace
}  // namespace plumb
