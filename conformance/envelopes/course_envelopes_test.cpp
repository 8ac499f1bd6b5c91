#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "conformance/envelopes/envelope_scene_for_tests.h"
#include "renderer/image/read_picture.h"

// The course's own pictures by the envelopes of the course's own scenes. They are other people's data: nothing of them
// is stored here.

namespace plumb {
namespace {

class CourseEnvelope : public ::testing::TestWithParam<const char*> {};

TEST_P(CourseEnvelope, HoldsTheCoursesPicture) {
  const std::string file = std::string(PLUMB_SHARED_DIR "/course/pa3-2011/") + GetParam() + ".xml";
  const EnvelopeScene scene(file);
  const Envelope e = scene.envelope();
  const Picture picture = read_picture(file + ".soln.png");
  ASSERT_EQ(picture.width, e.width);
  ASSERT_EQ(picture.height, e.height);
  const CheckResult result = judged(picture, e);
  EXPECT_EQ(compare_with_envelope(picture, e, 1).wrong_pixels(), 0) << result.summary << "; " << result.advice;
  EXPECT_LT(e.undecidable_share(), 0.05);
  RecordProperty("undecidable_percent", std::to_string(100 * e.undecidable_share()));

  Picture moved = picture;  // one to the right
  std::shift_right(moved.samples.begin(), moved.samples.end(), 3);
  EXPECT_EQ(judged(moved, e).verdict, Verdict::fail);
}

INSTANTIATE_TEST_SUITE_P(, CourseEnvelope,
                         ::testing::Values("Test4-glazed", "bunny10k_norms", "bunny500", "bunny500_norms",
                                           "bunny500_norms_aa", "glass-ball", "glazed-ball", "solids",
                                           "sphereMeshSquished", "sphereSquished"),
                         [](const auto& scene) {
                           std::string name = scene.param;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace plumb
