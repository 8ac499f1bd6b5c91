#include "conformance/pareto/picture_figures.h"

#include <time.h>

#include <algorithm>
#include <cmath>

#include "renderer/build_scene.h"
#include "renderer/film/render.h"
#include "renderer/kinds.h"
#include "scenes/read_scene.h"

namespace plumb {
namespace {

/// Of this process, over all of its threads.
double cpu_seconds() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct TimedPicture {
  Image image;
  double cpu_seconds;
};

/// Of a few, the median counts: low samples take milliseconds.
constexpr int kRepeats = 3;

TimedPicture rendered(const SceneDescription& description, const MeshTable& meshes, const PicturePlan& plan,
                      int samples, int repeats) {
  BuildOptions options;
  options.overrides.image_size = Size2{plan.width, plan.height};
  options.overrides.samples = samples;
  std::vector<std::string> warnings;
  const Scene scene = build_scene(description, meshes, options, warnings);
  TimedPicture picture{Image(0, 0), 0};
  std::vector<double> seconds;
  for (int i = 0; i < repeats; ++i) {
    const double before = cpu_seconds();
    picture.image = render(scene, {.threads = 1, .crop = std::nullopt, .progress = {}}).image;
    seconds.push_back(cpu_seconds() - before);
  }
  std::ranges::sort(seconds);
  picture.cpu_seconds = seconds[seconds.size() / 2];
  return picture;
}

}  // namespace

ColorDistance color_distance(const Image& a, const Image& b) {
  ColorDistance distance;
  double sum = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) {
    const Color& p = a.pixels()[i];
    const Color& q = b.pixels()[i];
    for (const double difference : {p.r - q.r, p.g - q.g, p.b - q.b}) {
      sum += difference * difference;
      distance.largest = std::max(distance.largest, std::fabs(difference));
    }
  }
  const double channels = 3 * static_cast<double>(std::max<std::size_t>(a.pixels().size(), 1));
  distance.rms = std::sqrt(sum / channels);
  return distance;
}

std::vector<PictureFigure> picture_figures(const std::filesystem::path& scene, const PicturePlan& plan,
                                           const std::function<void(double)>& progress) {
  const SceneDescription description = read_scene(scene, renderer_kinds(Dialect::pa3_2011));
  const MeshTable meshes = load_meshes(description);
  const Image converged = rendered(description, meshes, plan, plan.reference_samples, 1).image;
  std::vector<PictureFigure> figures;
  for (const int samples : plan.samples) {
    const TimedPicture picture = rendered(description, meshes, plan, samples, kRepeats);
    const ColorDistance distance = color_distance(picture.image, converged);
    figures.push_back({scene.stem().string(), plan.width, plan.height, samples, plan.reference_samples, distance.rms,
                       distance.largest, picture.cpu_seconds});
    progress(static_cast<double>(figures.size()) / static_cast<double>(plan.samples.size()));
  }
  return figures;
}

}  // namespace plumb
