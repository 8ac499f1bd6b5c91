#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "conformance/results/pareto_results.h"
#include "renderer/image/image.h"

namespace plumb {

struct PicturePlan {
  int width = 120, height = 90;
  /// Squares of whole numbers, as the renderer's samples lie on a grid.
  std::vector<int> samples{1, 4, 9, 16, 25};
  int reference_samples = 256;
};

/// Renders a scene with our renderer in one thread, with rising samples a pixel, and holds each picture against one
/// with `reference_samples`, which is taken for converged. Throws InputError for a scene that cannot be read.
std::vector<PictureFigure> picture_figures(const std::filesystem::path& scene, const PicturePlan& plan,
                                           const std::function<void(double)>& progress);

/// Root mean square and largest difference over all pixels and channels of two pictures of one size, in linear colour.
struct ColorDistance {
  double rms = 0, largest = 0;
};
ColorDistance color_distance(const Image& a, const Image& b);

}  // namespace plumb
