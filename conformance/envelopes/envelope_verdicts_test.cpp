#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "conformance/envelopes/envelope_scene_for_tests.h"

// What the verdict says of pictures of real scenes: of small errors everywhere, large ones where they are right, and
// colours that are cut off.

namespace plumb {
namespace {

constexpr const char* kScenes[] = {"shadows", "mesh-smooth", "glazed"};

/// Adds `levels` to a channel of every hundredth interior pixel that has room for it. Returns how many.
std::int64_t brighten_a_hundredth(Picture& picture, const Envelope& envelope, float levels) {
  std::int64_t count = 0;
  std::size_t seen = 0;
  for (std::size_t p = 0; p < envelope.pixels(); ++p) {
    float& v = picture.samples[3 * p + p % 3];
    if (envelope.reasons[p] != PixelReason::interior || v == 0 || v > 253 || seen++ % 100 != 0) continue;
    v += levels;
    ++count;
  }
  return count;
}

TEST(EnvelopeVerdict, IsAFailureForTwoLevelsOverOnePercentOfTheInterior) {
  int scenes = 0;
  for (const char* name : kScenes) {
    const EnvelopeScene scene = library_scene(name);
    const Envelope e = scene.envelope();
    Picture two = scene.drawn(scene.options()), one = two;
    const std::int64_t changed = brighten_a_hundredth(two, e, 2);
    const CheckResult result = judged(two, e);
    EXPECT_EQ(result.verdict, Verdict::fail) << name;
    EXPECT_EQ(result.cause, "different") << name;
    // Where the interval has two levels, two more than the lower one are within the tolerance.
    const auto wrong = static_cast<double>(compare_with_envelope(two, e, 1).wrong_pixels());
    EXPECT_GE(wrong, 0.98 * static_cast<double>(changed)) << name;
    EXPECT_LE(wrong, static_cast<double>(changed)) << name;
    EXPECT_GT(changed, 50) << name;
    EXPECT_EQ(brighten_a_hundredth(one, e, 1), changed) << name;
    EXPECT_EQ(compare_with_envelope(one, e, 1).wrong_pixels(), 0) << name;
    ++scenes;
  }
  EXPECT_EQ(scenes, 3);
}

TEST(EnvelopeVerdict, IsAPassForSilhouettesThatARightProgramMoves) {
  // A third of the perturbation's step, in another direction than any of its entries.
  std::int64_t moved = 0;
  for (const char* name : {"shadows", "mesh-smooth", "antialiasing"}) {
    const EnvelopeScene scene = library_scene(name);
    const Envelope e = scene.envelope();
    const Picture picture =
        scene.drawn(scene.options({.single = true, .t_min = 3e-5, .shift_x = 3e-4, .shift_y = 2e-4}));
    EXPECT_EQ(judged(picture, e).verdict, Verdict::pass) << name;
    for (std::size_t i = 0; i < picture.samples.size(); ++i)
      moved += std::abs(picture.samples[i] - static_cast<float>(e.nominal[i])) > 8;
  }
  EXPECT_GT(moved, 0) << "or no silhouette was moved, and the test shows nothing";
}

/// What a program draws that cuts its colours off in place of rounding them.
Picture cut_off(const Image& image) {
  Picture picture = EnvelopeScene::in_levels(image);
  for (std::size_t p = 0; p < image.pixels().size(); ++p) {
    const Color& c = image.pixels()[p];
    const double channels[] = {c.r, c.g, c.b};
    for (std::size_t k = 0; k < 3; ++k)
      picture.samples[3 * p + k] =
          static_cast<float>(std::floor(255 * std::pow(std::clamp(channels[k], 0.0, 1.0), 1 / 2.2)));
  }
  return picture;
}

TEST(EnvelopeVerdict, IsAWarningForLevelsThatAreCutOff) {
  int scenes = 0;
  for (const char* name : kScenes) {
    const EnvelopeScene scene = library_scene(name);
    const Envelope e = scene.envelope();
    const Image image = scene.image(scene.options());
    const CheckResult result = judged(cut_off(image), e);
    EXPECT_EQ(result.verdict, Verdict::quality_warning) << name;
    EXPECT_EQ(result.cause, "bias") << name;
    EXPECT_EQ(judged(EnvelopeScene::in_levels(image), e).verdict, Verdict::pass) << name;
    ++scenes;
  }
  EXPECT_EQ(scenes, 3);
}

}  // namespace
}  // namespace plumb
