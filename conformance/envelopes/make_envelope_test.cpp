#include "conformance/envelopes/make_envelope.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "conformance/envelopes/envelope_scene_for_tests.h"
#include "conformance/envelopes/jitter_camera.h"

namespace plumb {
namespace {

std::int64_t wrong(const Picture& picture, const Envelope& envelope) {
  return compare_with_envelope(picture, envelope, 1).wrong_pixels();
}

TEST(MakeEnvelope, HoldsTheReferenceTightly) {
  const EnvelopeScene scene = library_scene("shadows");
  const Envelope e = scene.envelope();
  std::vector<std::string> warnings;
  const Scene built = build_scene(scene.description, scene.meshes, {}, warnings);
  EXPECT_EQ(e.nominal, levels_of(render(built, {}).image));
  EXPECT_GT(std::ranges::count(e.reasons, PixelReason::silhouette), 0);
  EXPECT_LT(e.undecidable_share(), 0.005);
  int exact = 0;
  for (std::size_t i = 0; i < e.nominal.size(); ++i)
    if (e.reasons[i / 3] == PixelReason::interior) {
      EXPECT_LE(e.high[i] - e.low[i], 1) << i;
      exact += e.high[i] == e.low[i];
    }
  EXPECT_GT(exact, 0.99 * static_cast<double>(e.nominal.size())) << "most have one right answer";
}

TEST(MakeEnvelope, DoesNotDependOnThreads) {
  const EnvelopeScene scene = library_scene("glass");
  EXPECT_EQ(scene.envelope({}, 1), scene.envelope({}, 3));
}

TEST(MakeEnvelope, HoldsProgramsThatItWasNotMadeWith) {
  int programs = 0;
  for (const char* name : {"shadows", "glass", "glazed", "mesh-smooth", "rotations", "antialiasing"}) {
    const EnvelopeScene scene = library_scene(name);
    const Envelope e = scene.envelope();
    for (const TextbookOptions& options : {TextbookOptions{.single = true, .t_min = 3e-5},
                                           TextbookOptions{.t_min = 1e-7, .reverse_sums = true, .other_formulas = true},
                                           TextbookOptions{.single = true, .t_min = 5e-5, .reverse_sums = true}}) {
      EXPECT_EQ(wrong(scene.drawn(scene.options(options)), e), 0) << name;
      ++programs;
    }
  }
  EXPECT_EQ(programs, 18);
}

TEST(MakeEnvelope, LeavesOutWrongPrograms) {
  const EnvelopeScene glass = library_scene("glass");
  TextbookOptions options = glass.options();
  options.schlick = true;
  EXPECT_GT(wrong(glass.drawn(options), glass.envelope()), 100) << "Schlick's approximation";
  EXPECT_EQ(wrong(glass.drawn(options), glass.envelope({.id = "s", .fresnel = Fresnel::schlick})), 0);
  options = glass.options();
  options.shift_x = 0.5;
  EXPECT_GT(wrong(glass.drawn(options), glass.envelope()), 1000) << "half a pixel to the right";
  options = glass.options();
  options.single = true, options.t_min = 1e-9;
  EXPECT_GT(wrong(glass.drawn(options), glass.envelope()), 1000) << "acne";
  const EnvelopeScene fence = library_scene("antialiasing");
  options = fence.options();
  options.grid = 2;
  EXPECT_GT(wrong(fence.drawn(options), fence.envelope()), 100) << "other samples";
}

TEST(MakeEnvelope, OnlyVariantsThatDifferForTheSceneAreOthers) {
  const EnvelopeScene matt = library_scene("shadows"), glass = library_scene("glass"),
                      fence = library_scene("antialiasing");
  const Variant course, no_cutoff{.id = "n", .cutoff = false}, up{.id = "u", .samples = SampleRounding::up};
  EXPECT_TRUE(same_for(matt.description, course, no_cutoff));
  EXPECT_FALSE(same_for(glass.description, course, no_cutoff));
  EXPECT_TRUE(same_for(fence.description, course, up)) << "nine samples are a square";
  EXPECT_EQ(grid_side(8, SampleRounding::nearest), 3);
  EXPECT_EQ(grid_side(8, SampleRounding::down), 2);
  EXPECT_EQ(grid_side(10, SampleRounding::up), 4);
  EXPECT_EQ(grid_side(0, SampleRounding::down), 1);
}

TEST(Perturbations, AreEachFreeOfAcne) {
  // Alone, each differs from the reference by more than its rounding in a few pixels at edges.
  for (const char* name : {"glass", "rotations"}) {
    const EnvelopeScene scene = library_scene(name);
    const Picture reference = scene.drawn(scene.options());
    for (const Perturbation& p : perturbations()) {
      TextbookOptions options = p.options;
      const TextbookOptions of_scene = scene.options();
      options.grid = of_scene.grid, options.width = of_scene.width, options.height = of_scene.height;
      const Picture picture = scene.drawn(options);
      int off = 0;
      for (std::size_t i = 0; i < picture.samples.size(); i += 3)
        off += std::abs(picture.samples[i] - reference.samples[i]) > 2;
      EXPECT_LT(off, 0.004 * static_cast<double>(picture.samples.size() / 3)) << name << ": " << p.what;
    }
  }
  EXPECT_GE(perturbations().size(), 12u);
}

TEST(JitteredCamera, StaysNearAndIsTheSameForASeed) {
  const EnvelopeScene scene = library_scene("oblique-camera");
  std::vector<std::string> warnings;
  const Scene built = build_scene(scene.description, scene.meshes, {}, warnings);
  const ObjectDescription& camera = *scene.description.scene->object("camera");
  const CameraPlace one = jittered_camera(scene.description, built, 7, 1);
  const CameraPlace again = jittered_camera(scene.description, built, 7, 1);
  const CameraPlace other = jittered_camera(scene.description, built, 7, 2);
  EXPECT_EQ(one.view_point, again.view_point);
  EXPECT_NE(one.view_point, other.view_point);
  const Vec3 before = normalized(camera.vector("viewDir")), after = normalized(one.view_dir);
  EXPECT_GT(dot(before, after), 0.9975) << "by 4 degrees at most";
  EXPECT_LT(dot(before, after), 1);
  ASSERT_TRUE(one.proj_normal.has_value());
  EXPECT_NEAR(dot(normalized(*one.proj_normal), after), dot(normalized(camera.vector("projNormal")), before), 1e-12);
}

TEST(JitteredCamera, OfASceneWithoutOneIsTheDefaultCamerasMoved) {
  const ReadScene read = scene_of("<surface type='Sphere'><center>0 0 -4</center></surface>");
  const CameraPlace place = jittered_camera(read.description, read.scene, 3, 1);
  EXPECT_NE(place.view_point, (Point3{0, 0, 0}));
  EXPECT_LT(dot(normalized(place.view_dir), Vec3{0, 0, -1}), 1);
  EXPECT_GT(dot(normalized(place.view_dir), Vec3{0, 0, -1}), 0.9975);
  EXPECT_FALSE(place.proj_normal.has_value());
}

}  // namespace
}  // namespace plumb
