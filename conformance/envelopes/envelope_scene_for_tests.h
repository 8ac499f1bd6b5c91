#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "conformance/envelopes/judge_envelope.h"
#include "conformance/envelopes/make_envelope.h"
#include "renderer/scene_for_tests.h"

namespace plumb {

/// A scene, ready for envelopes and for the textbook tracer's pictures.
struct EnvelopeScene {
  explicit EnvelopeScene(const std::filesystem::path& file)
      : description(read_scene(file, renderer_kinds(Dialect::pa3_2011))), meshes(load_meshes(description)) {}

  Envelope envelope(const Variant& variant = {}, int threads = 0) const {
    return make_envelope({.description = description, .meshes = meshes, .variant = variant, .threads = threads});
  }

  TextbookOptions options() const { return textbook_options(description); }

  /// What these options say of precision and formulas, and the scene of all else.
  TextbookOptions options(TextbookOptions options) const {
    const TextbookOptions of_scene = textbook_options(description);
    options.grid = of_scene.grid, options.width = of_scene.width, options.height = of_scene.height;
    options.max_depth = of_scene.max_depth, options.min_contribution = of_scene.min_contribution;
    return options;
  }

  Image image(const TextbookOptions& options) const {
    return textbook_picture(textbook_samples(description, meshes, options, 0), options);
  }
  Picture drawn(const TextbookOptions& options) const { return in_levels(image(options)); }

  static Picture in_levels(const Image& image) {
    Picture picture;
    picture.width = image.width(), picture.height = image.height();
    const std::vector<std::uint8_t> levels = levels_of(image);
    picture.samples.assign(levels.begin(), levels.end());
    return picture;
  }

  SceneDescription description;
  MeshTable meshes;
};

inline EnvelopeScene library_scene(const std::string& name) {
  return EnvelopeScene(std::filesystem::path(PLUMB_SOURCE_DIR) / "scenes/library" / (name + ".xml"));
}

inline CheckResult judged(const Picture& picture, const Envelope& envelope) {
  return judge_findings(compare_with_envelope(picture, envelope, 1), picture, envelope, 1);
}

}  // namespace plumb
