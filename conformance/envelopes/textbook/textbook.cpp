#include "conformance/envelopes/textbook/textbook.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "conformance/envelopes/textbook/build.h"
#include "conformance/envelopes/textbook/shading.h"
#include "renderer/film/tiles.h"

namespace plumb {
namespace {

using textbook::Arithmetic;

/// The camera's ray through (u, v) of its window, from its lower left corner.
template <class A>
textbook::Vector<A> camera_direction(const textbook::Scene<A>& scene, textbook::RealOf<A> u, textbook::RealOf<A> v) {
  using Real = textbook::RealOf<A>;
  const textbook::Camera<A>& camera = scene.camera;
  const textbook::Vector<A> direction = camera.to_center + (u - Real(0.5)) * camera.right + (v - Real(0.5)) * camera.up;
  return scene.formulas == textbook::Formulas::usual ? unit(direction) : direction;
}

template <class A>
std::vector<TextbookSample> samples_in(const SceneDescription& description, const MeshTable& meshes,
                                       const TextbookOptions& options, int threads) {
  using Real = textbook::RealOf<A>;
  const textbook::Scene<A> scene = textbook::SceneBuilder<A>(description, meshes, options).build();
  const auto width = static_cast<std::size_t>(options.width), height = static_cast<std::size_t>(options.height);
  const auto grid = static_cast<std::size_t>(options.grid);
  std::vector<TextbookSample> samples(width * height * grid * grid);
  // The place of a sample on one side of the picture, in [0, 1].
  const auto place = [&](std::size_t pixel, std::size_t step, double shift, std::size_t side) {
    const Real within = (static_cast<Real>(step) + Real(0.5)) / static_cast<Real>(grid);
    return (static_cast<Real>(pixel) + within + static_cast<Real>(shift)) / static_cast<Real>(side);
  };
  for_each_item(thread_count(threads), options.height, [&](int, int item) {
    const auto row = static_cast<std::size_t>(item);
    textbook::Tracer<A> tracer(scene, options);
    TextbookSample* sample = &samples[row * width * grid * grid];
    for (std::size_t x = 0; x < width; ++x) {
      for (std::size_t j = 0; j < grid; ++j) {
        for (std::size_t i = 0; i < grid; ++i) {
          const Real u = place(x, i, options.shift_x, width);
          const Real v = place(height - 1 - row, j, options.shift_y, height);
          *sample++ = tracer.sample(scene.camera.eye, camera_direction(scene, u, v));
        }
      }
    }
  });
  return samples;
}

}  // namespace

TextbookOptions textbook_options(const SceneDescription& description) {
  TextbookOptions options;
  const ObjectDescription& scene = *description.scene;
  options.grid = std::max(1, static_cast<int>(std::lround(std::sqrt(scene.integer("samples")))));
  options.max_depth = scene.integer("maxDepth");
  options.min_contribution = scene.number("minContribution");
  options.width = scene.size("image").width;
  options.height = scene.size("image").height;
  return options;
}

std::vector<TextbookSample> textbook_samples(const SceneDescription& description, const MeshTable& meshes,
                                             const TextbookOptions& options, int threads) {
  if (options.width <= 0 || options.height <= 0 || options.grid <= 0)
    throw std::invalid_argument("a picture needs a positive width, height and grid of samples");
  if (options.single) {
    return options.reverse_sums ? samples_in<Arithmetic<float, true>>(description, meshes, options, threads)
                                : samples_in<Arithmetic<float, false>>(description, meshes, options, threads);
  }
  return options.reverse_sums ? samples_in<Arithmetic<double, true>>(description, meshes, options, threads)
                              : samples_in<Arithmetic<double, false>>(description, meshes, options, threads);
}

Image textbook_picture(const std::vector<TextbookSample>& samples, const TextbookOptions& options) {
  const auto in_pixel = static_cast<std::size_t>(options.grid) * static_cast<std::size_t>(options.grid);
  Image image(options.width, options.height);
  auto pixel = samples.begin();
  for (int y = 0; y < options.height; ++y) {
    for (int x = 0; x < options.width; ++x, pixel += static_cast<std::ptrdiff_t>(in_pixel)) {
      Color sum;
      for (std::size_t i = 0; i < in_pixel; ++i)
        sum += pixel[static_cast<std::ptrdiff_t>(options.reverse_sums ? in_pixel - 1 - i : i)].color;
      image.at(x, y) = 1 / static_cast<double>(in_pixel) * sum;
    }
  }
  return image;
}

}  // namespace plumb
