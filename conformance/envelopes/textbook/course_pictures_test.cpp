#include "conformance/envelopes/textbook/agreement_for_tests.h"
#include "renderer/image/read_picture.h"

// The course's own scenes against the course's own pictures. They are other people's data: nothing of them is stored
// here.

namespace plumb {
namespace {

int different_from_course(const std::filesystem::path& file, bool schlick) {
  const TextbookScene scene(file);
  const Image image = scene.picture(scene.with([&](TextbookOptions& o) { o.schlick = schlick; }));
  const Picture expected = read_picture(file.string() + ".soln.png");
  const std::vector<std::uint8_t> levels = levels_of(image);
  std::vector<std::uint8_t> of_course(expected.samples.size());
  std::ranges::transform(expected.samples, of_course.begin(), [](float s) { return static_cast<std::uint8_t>(s); });
  if (levels.size() != of_course.size()) return image.width() * image.height();
  return pixels_apart_by_levels(levels, of_course, 0);
}

TEST(TextbookCoursePictures, OfPa3HaveHardlyADifferentPixel) {
  int scenes = 0, different = 0;
  for (const auto& file : scenes_in(PLUMB_SHARED_DIR "/course/pa3-2011")) {
    const int pixels = different_from_course(file, false);
    EXPECT_LE(pixels, 2) << file;  // none was seen
    different += pixels;
    ++scenes;
  }
  RecordProperty("different_pixels", different);
  EXPECT_EQ(scenes, 10);
}

TEST(TextbookCoursePictures, OfTheCourseWithSchlickToo) {
  int scenes = 0;
  for (const char* name : {"one-blue-cylinder", "one-sphere", "wire-box-3"}) {
    EXPECT_LE(different_from_course(std::string(PLUMB_SHARED_DIR "/course/cs461-2012/") + name + ".xml", true), 2)
        << name;
    ++scenes;
  }
  EXPECT_EQ(scenes, 3);
}

TEST(TextbookCoursePictures, TellSchlickFromFresnel) {
  EXPECT_GT(different_from_course(PLUMB_SHARED_DIR "/course/pa3-2011/glass-ball.xml", true), 1000);
}

}  // namespace
}  // namespace plumb
