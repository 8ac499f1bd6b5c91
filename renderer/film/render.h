#pragma once

#include <functional>
#include <optional>

#include "renderer/film/tiles.h"
#include "renderer/image/image.h"
#include "renderer/integrator/trace_counters.h"
#include "renderer/scene.h"

namespace plumb {

struct RenderOptions {
  /// 0 for as many as there are processors.
  int threads = 0;
  /// The part of the picture to render; all of it by default. Must lie within the picture.
  std::optional<PixelRect> crop;
  /// Called now and then with the share that is done, from any thread but never from two at once.
  std::function<void(double)> progress;
};

struct Rendering {
  /// Of the size of the crop.
  Image image;
  TraceCounters counters;
};

/// The picture of a scene, by regular supersampling. The same bits for any number of threads, and for a crop the same
/// as in that part of the whole.
Rendering render(const Scene& scene, const RenderOptions& options);

/// The side N of the N x N grid of samples that this many samples a pixel are rounded to: round(sqrt(samples)), at
/// least 1.
int sample_grid(int samples);

}  // namespace plumb
