#include "renderer/film/render.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <thread>
#include <vector>

#include "renderer/integrator/tracer.h"

namespace plumb {
namespace {

/// The mean of N x N samples in the middles of a grid; `row` counts from the top, the camera's v from the bottom.
Color pixel_color(Tracer& tracer, int x, int row) {
  const Scene& scene = tracer.scene();
  const auto [width, height] = scene.image_size();
  const int y = height - 1 - row;
  const int n = sample_grid(scene.samples());
  Color sum;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const double u = (x + (i + 0.5) / n) / width;
      const double v = (y + (j + 0.5) / n) / height;
      sum += tracer.trace(scene.camera().ray(u, v), RayKind::primary, Path{});
    }
  }
  return 1.0 / (n * n) * sum;
}

}  // namespace

int sample_grid(int samples) { return std::max(1, static_cast<int>(std::lround(std::sqrt(samples)))); }

Rendering render(const Scene& scene, const RenderOptions& options) {
  const PixelRect area = options.crop.value_or(PixelRect{0, 0, scene.image_size().width, scene.image_size().height});
  const std::vector<PixelRect> tiles = tiles_of(area);
  const int threads = thread_count(options.threads);
  std::vector<Tracer> tracers(static_cast<std::size_t>(threads), Tracer(scene));
  Rendering rendering{Image(area.width, area.height), {}};
  std::mutex progress_mutex;
  std::size_t tiles_done = 0;

  for_each_item(threads, static_cast<int>(tiles.size()), [&](int worker, int item) {
    const PixelRect& tile = tiles[static_cast<std::size_t>(item)];
    Tracer& tracer = tracers[static_cast<std::size_t>(worker)];
    for (int y = tile.y; y < tile.y + tile.height; ++y)
      for (int x = tile.x; x < tile.x + tile.width; ++x)
        rendering.image.at(x - area.x, y - area.y) = pixel_color(tracer, x, y);
    if (options.progress) {
      const std::lock_guard lock(progress_mutex);
      options.progress(static_cast<double>(++tiles_done) / static_cast<double>(tiles.size()));
    }
  });
  for (const Tracer& tracer : tracers) rendering.counters.add(tracer.counters());
  return rendering;
}

}  // namespace plumb
