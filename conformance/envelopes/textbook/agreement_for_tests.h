#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "conformance/envelopes/textbook/textbook.h"
#include "renderer/scene_for_tests.h"

namespace plumb {

/// A scene, ready for the textbook tracer.
struct TextbookScene {
  SceneDescription description;
  MeshTable meshes;
  TextbookOptions options;

  explicit TextbookScene(const std::filesystem::path& file)
      : description(read_scene(file, renderer_kinds(Dialect::pa3_2011))),
        meshes(load_meshes(description)),
        options(textbook_options(description)) {}

  template <class Change>
  TextbookOptions with(Change&& change) const {
    TextbookOptions changed = options;
    change(changed);
    return changed;
  }
  std::vector<TextbookSample> samples(const TextbookOptions& by, int threads = 2) const {
    return textbook_samples(description, meshes, by, threads);
  }
  Image picture(const TextbookOptions& by) const { return textbook_picture(samples(by), by); }
};

/// Colours of two correct programs differ by 2^-53 times what curved mirrors and grazing roots make of a rounding.
/// Pixels in which that is more than 10^7 are undecidable; all others are within this.
constexpr double kSameColor = 1e-9;

/// How many pixels differ by more in some channel, or are not numbers.
inline int pixels_apart(const Image& a, const Image& b, double most = kSameColor) {
  const auto near = [&](double x, double y) { return std::fabs(x - y) <= most; };
  int apart = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) {
    const Color &p = a.pixels()[i], &q = b.pixels().at(i);
    apart += !(near(p.r, q.r) && near(p.g, q.g) && near(p.b, q.b));
  }
  return apart;
}

/// How many pixels differ by more than `most` levels in some channel.
inline int pixels_apart_by_levels(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b, int most) {
  int apart = 0;
  for (std::size_t i = 0; i + 2 < a.size(); i += 3) {
    int largest = 0;
    for (std::size_t k = i; k < i + 3; ++k) largest = std::max(largest, std::abs(a[k] - b.at(k)));
    apart += largest > most;
  }
  return apart;
}

inline std::vector<std::filesystem::path> scenes_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".xml") files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

}  // namespace plumb
