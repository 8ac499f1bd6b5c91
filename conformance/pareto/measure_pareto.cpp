#include "conformance/pareto/measure_pareto.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "conformance/families/closed_meshes.h"
#include "conformance/pareto/class_figures.h"
#include "conformance/pareto/closest_figures.h"
#include "conformance/pareto/contender.h"
#include "conformance/pareto/escape_figures.h"
#include "conformance/pareto/picture_figures.h"
#include "conformance/pareto/speed_figures.h"
#include "conformance/subject/kernel_cost.h"
#include "conformance/subject/kernel_subject.h"
#include "conformance/subject/shipped_kernels.h"

namespace plumb {
namespace {

constexpr plumb_precision kPrecisions[] = {PLUMB_FLOAT, PLUMB_DOUBLE};
constexpr MeshAim kAims[] = {MeshAim::vertices, MeshAim::edges, MeshAim::faces};

std::int64_t scaled(std::int64_t count, double intensity) {
  return std::max<std::int64_t>(24, std::llround(static_cast<double>(count) * intensity));
}

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(std::min(line.find(':') + 2, line.size()));
  return "unknown";
}

/// One table: contenders, and a column of results for each.
class Table {
 public:
  Table(std::vector<Contender> contenders, const ParetoPlan& plan) : contenders_(std::move(contenders)), plan_(plan) {
    for (const Contender& contender : contenders_) {
      columns_.push_back({contender.name,
                          contender.inputs == PLUMB_FLOAT ? "float" : "double",
                          contender.subject->description(),
                          {},
                          {},
                          {},
                          {}});
    }
  }

  void measure_speed(SpeedScene (*scene)(const Rounding&), const std::string& what) {
    SpeedPlan speed;
    speed.seconds *= std::min(1.0, plan_.intensity);
    speed.rays = static_cast<std::size_t>(
        std::min<std::int64_t>(static_cast<std::int64_t>(speed.rays), scaled(1 << 20, plan_.intensity)));
    const std::vector<SpeedFigure> figures =
        speed_figures(contenders_, scene, speed, plan_.seed, progress(what + ": speed"));
    for (std::size_t k = 0; k < columns_.size(); ++k) columns_[k].speed = figures[k];
  }

  void measure_class(const ClassQuestion& question, const std::string& what) {
    const std::int64_t count = scaled(kParetoClassRays, plan_.intensity);
    for_each_precision([&](std::span<Contender* const> asked, plumb_precision) {
      append(asked, &ParetoKernel::classes,
             class_figures(asked, question, plan_.seed, count, progress(what + ": " + std::string(question.name))));
    });
  }

  void measure_escapes(MeshAim aim) {
    const std::int64_t count = scaled(kParetoEscapeRays, plan_.intensity);
    for_each_precision([&](std::span<Contender* const> asked, plumb_precision inputs) {
      append(asked, &ParetoKernel::escapes,
             escape_figures(asked, closed_meshes(inputs), aim, plan_.seed, count,
                            progress("escapes at " + std::string(to_string(aim)))));
    });
  }

  void measure_closest(std::size_t scene, MeshAim aim) {
    const std::int64_t count = scaled(kParetoClosestRays, plan_.intensity);
    for_each_precision([&](std::span<Contender* const> asked, plumb_precision inputs) {
      const ClosestScene mesh = closest_scenes(inputs)[scene];
      append(asked, &ParetoKernel::closest,
             closest_figures(asked, mesh, aim, plan_.seed, count,
                             progress("closest surface of " + mesh.name + ", " + std::string(to_string(aim)))));
    });
  }

  std::vector<ParetoKernel> columns(std::vector<std::string>& notes) && {
    for (Contender& contender : contenders_) std::ranges::move(contender.failures, std::back_inserter(notes));
    return std::move(columns_);
  }

 private:
  std::function<void(double)> progress(const std::string& what) const {
    return [this, what](double share) { plan_.progress(what, share); };
  }

  template <class Measure>
  void for_each_precision(Measure measure) {
    for (const plumb_precision inputs : kPrecisions) {
      const std::vector<Contender*> asked = with_inputs(contenders_, inputs);
      if (!asked.empty()) measure(asked, inputs);
    }
  }

  template <class Figure>
  void append(std::span<Contender* const> asked, std::vector<Figure> ParetoKernel::*list, std::vector<Figure> figures) {
    for (std::size_t k = 0; k < asked.size(); ++k) {
      const auto column = static_cast<std::size_t>(asked[k] - contenders_.data());
      (columns_[column].*list).push_back(std::move(figures[k]));
    }
  }

  std::vector<Contender> contenders_;
  std::vector<ParetoKernel> columns_;
  const ParetoPlan& plan_;
};

void measure_triangles(const ParetoPlan& plan, ParetoResults& results) {
  results.triangle_scene = speed_mesh(Rounding(PLUMB_FLOAT)).description;
  Table table(shipped_contenders(plan.kernels, PLUMB_MESHES, 0), plan);
  table.measure_speed(speed_mesh, "triangles");
  for (const ClassQuestion& question : triangle_questions()) table.measure_class(question, "triangles");
  for (const MeshAim aim : kAims) table.measure_escapes(aim);
  for (std::size_t scene = 0; scene < closest_scenes(PLUMB_FLOAT).size(); ++scene)
    for (const MeshAim aim : {MeshAim::edges, MeshAim::faces}) table.measure_closest(scene, aim);
  results.triangles = std::move(table).columns(results.notes);
}

void measure_spheres(const ParetoPlan& plan, ParetoResults& results) {
  results.sphere_scene = speed_spheres(Rounding(PLUMB_FLOAT)).description;
  Table table(shipped_contenders(plan.kernels, PLUMB_SPHERES, PLUMB_TRANSFORMS), plan);
  table.measure_speed(speed_spheres, "spheres");
  for (const ClassQuestion& question : sphere_questions()) table.measure_class(question, "spheres");
  results.spheres = std::move(table).columns(results.notes);
}

void measure_pictures(const ParetoPlan& plan, ParetoResults& results) {
  PicturePlan pictures;
  const double scale = std::sqrt(std::min(16.0, plan.intensity));
  pictures.width = std::max(16, static_cast<int>(std::lround(scale * pictures.width)));
  pictures.height = std::max(12, static_cast<int>(std::lround(scale * pictures.height)));
  for (const std::filesystem::path& scene : plan.scenes) {
    const std::string what = "pictures of " + scene.stem().string();
    plan.progress(what, 0);
    const auto figures = picture_figures(scene, pictures, [&](double share) { plan.progress(what, share); });
    results.pictures.insert(results.pictures.end(), figures.begin(), figures.end());
  }
}

}  // namespace

ParetoResults measure_pareto(const ParetoPlan& plan) {
  ParetoResults results;
  results.seed = plan.seed;
  results.intensity = plan.intensity;
  results.processor = processor_name();
  {
    constexpr std::size_t kRays = 100'000;
    constexpr int kCalls = 7;
    KernelSubject nothing(shipped_kernel("empty"));
    const AskingCost cost = asking_cost(nothing, kRays, kCalls);
    results.empty_cpu_nanoseconds = cost.cpu_nanoseconds_a_ray;
    results.empty_clock_nanoseconds = cost.clock_nanoseconds_a_ray;
  }
  measure_triangles(plan, results);
  measure_spheres(plan, results);
  measure_pictures(plan, results);
  return results;
}

}  // namespace plumb
