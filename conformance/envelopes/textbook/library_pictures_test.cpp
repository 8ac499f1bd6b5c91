#include "conformance/envelopes/textbook/agreement_for_tests.h"

// The scene library by the textbook tracer, plain and with each perturbation.

namespace plumb {
namespace {

constexpr std::size_t kScenes = 13;  // of the library, at least

/// One pixel in a thousand, and at least one.
int few(const TextbookScene& scene) { return 1 + scene.options.width * scene.options.height / 1000; }

template <class Change>
int levels_apart(const TextbookScene& scene, const Image& usual, int most, Change&& change) {
  const Image changed = scene.picture(scene.with(change));
  return pixels_apart_by_levels(levels_of(usual), levels_of(changed), most);
}

TEST(LibraryPictures, AreTheRenderers) {
  std::size_t scenes = 0, lit = 0, apart = 0;
  for (const auto& file : scenes_in(PLUMB_SOURCE_DIR "/scenes/library")) {
    const TextbookScene scene(file);
    const Image expected = render(read_and_build(file).scene, {}).image;
    const Image image = scene.picture(scene.options);
    const int different = pixels_apart(image, expected);
    EXPECT_LE(different, 3) << file;  // none was seen
    EXPECT_LE(pixels_apart_by_levels(levels_of(image), levels_of(expected), 0), 3) << file;
    for (const Color& color : image.pixels()) lit += color != Color{};
    apart += static_cast<std::size_t>(different);
    ++scenes;
  }
  RecordProperty("different_pixels", static_cast<int>(apart));
  EXPECT_GE(scenes, kScenes);
  EXPECT_GT(lit, 100000u);
}

TEST(LibraryPictures, FloatsMakeNoAcneButBelowTheirOffset) {
  // Pixels with more than two levels of difference. What is left with 1e-5 and 1e-4 are edges; with 1e-9 a tenth of
  // the pixels of most scenes is wrong.
  std::size_t scenes = 0, with_acne = 0;
  for (const auto& file : scenes_in(PLUMB_SOURCE_DIR "/scenes/library")) {
    const TextbookScene scene(file);
    const Image usual = scene.picture(scene.options);
    const auto apart = [&](double t_min) {
      return levels_apart(scene, usual, 2, [&](TextbookOptions& o) { o.single = true, o.t_min = t_min; });
    };
    EXPECT_LE(apart(1e-5), few(scene)) << file;
    EXPECT_LE(apart(1e-4), few(scene)) << file;
    with_acne += apart(1e-9) > 10 * few(scene);
    ++scenes;
  }
  EXPECT_GE(scenes, kScenes);
  EXPECT_GE(with_acne, kScenes - 1);  // seen in all 13
}

TEST(LibraryPictures, EachPerturbationChangesBitsOfMostScenesAndFewPixels) {
  using Change = void (*)(TextbookOptions&);
  const std::pair<const char*, Change> changes[] = {
      {"reverse_sums", [](TextbookOptions& o) { o.reverse_sums = true; }},
      {"other_formulas", [](TextbookOptions& o) { o.other_formulas = true; }},
      {"shift_x", [](TextbookOptions& o) { o.shift_x = 1e-5; }},
      {"shift_y", [](TextbookOptions& o) { o.shift_y = -1e-5; }},
      {"vertex_noise", [](TextbookOptions& o) { o.vertex_noise = 1e-7; }},
      {"single", [](TextbookOptions& o) { o.single = true, o.t_min = 1e-5; }},
      {"t_min 1e-9", [](TextbookOptions& o) { o.t_min = 1e-9; }},
      {"t_min 1e-4", [](TextbookOptions& o) { o.t_min = 1e-4; }},
  };
  std::size_t scenes = 0;
  std::vector<std::size_t> bits_changed(std::size(changes));
  for (const auto& file : scenes_in(PLUMB_SOURCE_DIR "/scenes/library")) {
    const TextbookScene scene(file);
    const Image usual = scene.picture(scene.options);
    for (std::size_t i = 0; i < std::size(changes); ++i) {
      const auto& [name, change] = changes[i];
      const Image changed = scene.picture(scene.with(change));
      bits_changed[i] += changed.pixels() != usual.pixels();
      EXPECT_LE(pixels_apart_by_levels(levels_of(usual), levels_of(changed), 1), few(scene)) << name << " " << file;
    }
    ++scenes;
  }
  EXPECT_GE(scenes, kScenes);
  // t_min alone moves no number that is not near an edge.
  for (std::size_t i = 0; i + 2 < std::size(changes); ++i) EXPECT_GE(bits_changed[i], kScenes) << changes[i].first;
}

}  // namespace
}  // namespace plumb
