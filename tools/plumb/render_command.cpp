#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "renderer/build_scene.h"
#include "renderer/film/render.h"
#include "renderer/image/staged_file.h"
#include "renderer/image/write_image.h"
#include "renderer/kinds.h"
#include "renderer/math/input_error.h"
#include "scenes/read_scene.h"
#include "tools/plumb/arguments.h"
#include "tools/plumb/command.h"
#include "tools/plumb/progress_bar.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::vector<std::string> scenes;
  std::string output;
  int threads = 0;
  std::optional<int> samples;
  std::optional<std::string> size;
  std::optional<std::string> crop;
  std::string dialect = "pa3-2011";
  std::string fresnel = "exact";
  std::optional<int> max_depth;
  std::optional<double> min_contribution;
  std::string accel = "bvh8";
  std::string stats;
};

/// The arguments, understood.
struct Plan {
  KindTable kinds;
  BuildOptions build;
  RenderOptions render;
};

struct Job {
  fs::path scene;
  fs::path picture;
};

/// What one scene cost.
struct Cost {
  double read = 0, build = 0, render = 0, write = 0;
  TraceCounters counters;
};

/// Seconds since the last call.
class Stopwatch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

Plan plan_of(const Arguments& arguments) {
  Plan plan;
  plan.kinds = renderer_kinds(dialect_named(arguments.dialect));
  plan.build.fresnel = static_cast<Fresnel>(parse_choice("--fresnel", arguments.fresnel, fresnel_names()));
  plan.build.accel = static_cast<Accel>(parse_choice("--accel", arguments.accel, accel_names()));
  plan.build.overrides = {.image_size = std::nullopt,
                          .samples = arguments.samples,
                          .max_depth = arguments.max_depth,
                          .min_contribution = arguments.min_contribution};
  if (arguments.size) plan.build.overrides.image_size = parse_size(*arguments.size);
  plan.build.threads = plan.render.threads = arguments.threads;
  if (arguments.crop) plan.render.crop = parse_rect(*arguments.crop);
  return plan;
}

/// `X.xml` gives `X.xml.png` beside it, or in the folder that -o names; for a single scene -o may name a file.
std::vector<Job> jobs_of(const Arguments& arguments) {
  const std::vector<fs::path> scenes = scene_files(arguments.scenes);
  const fs::path output = arguments.output;
  const bool asks_for_several = scenes.size() > 1 || fs::is_directory(arguments.scenes.front());
  const bool into_folder = !output.empty() && (asks_for_several || !output.has_filename() || fs::is_directory(output));
  if (into_folder) {
    if (!fs::is_directory(output) && (output.extension() == ".png" || output.extension() == ".exr"))
      throw InputError({output.string()}, "-o names a picture, but several scenes are rendered; expected a folder");
    std::error_code error;
    fs::create_directories(output, error);
    if (!fs::is_directory(output))
      throw InputError({output.string()}, "cannot make the folder for the pictures: " + error.message());
  }
  std::vector<Job> jobs;
  std::set<fs::path> pictures;
  for (const fs::path& scene : scenes) {
    fs::path picture = into_folder ? output / scene.filename() : output.empty() ? scene : output;
    if (into_folder || output.empty()) picture += ".png";
    if (!pictures.insert(picture.lexically_normal()).second) {
      throw InputError({scene.string()},
                       "its picture '" + picture.string() + "' would overwrite that of another scene of this command");
    }
    jobs.push_back({scene, picture});
  }
  return jobs;
}

void check_crop(const RenderOptions& options, Size2 size) {
  if (!options.crop) return;
  const PixelRect& c = *options.crop;
  if (c.x > size.width - c.width || c.y > size.height - c.height) {
    throw InputError({}, fmt::format("--crop: {},{},{},{} reaches outside of the picture of {}x{}", c.x, c.y, c.width,
                                     c.height, size.width, size.height));
  }
}

Cost render_scene(const Job& job, const Plan& plan) {
  Cost cost;
  Stopwatch watch;
  require_image_writable(job.picture);
  const SceneDescription description = read_scene(job.scene, plan.kinds);
  std::vector<std::string> warnings = description.warnings;
  const MeshTable meshes = load_meshes(description);
  cost.read = watch.lap();
  const Scene scene = build_scene(description, meshes, plan.build, warnings);
  for (const std::string& warning : warnings) fmt::print(stderr, "{}\n", warning);
  check_crop(plan.render, scene.image_size());
  cost.build = watch.lap();
  RenderOptions options = plan.render;
  ProgressBar bar(job.scene.filename().string());
  options.progress = [&](double share) { bar.show(share); };
  const Rendering rendering = render(scene, options);
  cost.render = watch.lap();
  write_image(rendering.image, job.picture);
  cost.write = watch.lap();
  cost.counters = rendering.counters;
  return cost;
}

nlohmann::ordered_json stats_json(const Job& job, const Cost& cost) {
  const auto& rays = cost.counters.rays;
  return {{"scene", job.scene.string()},
          {"picture", job.picture.string()},
          {"rays", {{"primary", rays[0]}, {"reflection", rays[1]}, {"refraction", rays[2]}, {"shadow", rays[3]}}},
          {"node_visits", cost.counters.node_visits},
          {"primitive_tests", cost.counters.primitive_tests},
          {"seconds", {{"read", cost.read}, {"build", cost.build}, {"render", cost.render}, {"write", cost.write}}}};
}

void print_stats(const Job& job, const Cost& cost) {
  const auto& rays = cost.counters.rays;
  fmt::print("{}\n", job.scene.string());
  fmt::print("  rays             primary {}, reflection {}, refraction {}, shadow {}\n", rays[0], rays[1], rays[2],
             rays[3]);
  fmt::print("  node visits      {}\n", cost.counters.node_visits);
  fmt::print("  primitive tests  {}\n", cost.counters.primitive_tests);
  fmt::print("  seconds          read {:.3f}, build {:.3f}, render {:.3f}, write {:.3f}\n", cost.read, cost.build,
             cost.render, cost.write);
}

int run(const Arguments& arguments) {
  const Plan plan = plan_of(arguments);
  const bool stats_to_file = !arguments.stats.empty() && arguments.stats != "-";
  if (stats_to_file) require_writable(arguments.stats);
  int status = 0;
  nlohmann::ordered_json stats = nlohmann::ordered_json::array();
  for (const Job& job : jobs_of(arguments)) {
    try {
      const Cost cost = render_scene(job, plan);
      if (stats_to_file) stats.push_back(stats_json(job, cost));
      if (arguments.stats == "-") print_stats(job, cost);
    } catch (const InputError& error) {  // the command's other scenes are still rendered
      fmt::print(stderr, "{}\n", error.what());
      status = 2;
    }
  }
  if (stats_to_file) write_file_staged(arguments.stats, stats.dump(2) + "\n");
  return status;
}

}  // namespace

void add_render_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("render", "Render scenes: X.xml gives X.xml.png beside it");
  const auto arguments = std::make_shared<Arguments>();
  Arguments& a = *arguments;
  command->add_option("scenes", a.scenes, "Scenes, or folders of scenes (*.xml)")->required()->type_name("SCENE");
  command
      ->add_option("-o,--output", a.output,
                   "The picture (.png, or .exr: linear) of a single scene; a folder for several")
      ->type_name("PATH");
  command->add_option("--threads", a.threads, "Threads [all processors]")->check(CLI::Range(1, 1024))->type_name("N");
  command->add_option("--samples", a.samples, "Samples a pixel, in place of the scene's")
      ->check(CLI::Range(1, 1 << 20))
      ->type_name("N");
  command->add_option("--size", a.size, "Size of the picture, in place of the scene's")->type_name("WxH");
  command->add_option("--crop", a.crop, "Only this part of the picture, rows from the top")->type_name("X,Y,W,H");
  command->add_option("--dialect", a.dialect, "Rules of the scene format: " + joined(dialect_names()))
      ->capture_default_str();
  command->add_option("--fresnel", a.fresnel, "Reflectance of Glass and Glazed: " + joined(fresnel_names()))
      ->capture_default_str();
  command->add_option("--max-depth", a.max_depth, "Longest chain of rays, in place of the scene's")
      ->check(CLI::Range(1, 1000))
      ->type_name("N");
  command
      ->add_option("--min-contribution", a.min_contribution,
                   "Rays that would count for less are dropped, in place of the scene's")
      ->check(CLI::Range(0.0, 1.0))
      ->type_name("X");
  command->add_option("--accel", a.accel, "How hits are found: " + joined(accel_names()))->capture_default_str();
  command
      ->add_flag("--stats{-}", a.stats,
                 "Print rays, node visits, primitive tests and seconds, or write them to FILE.json")
      ->type_name("[=FILE.json]");
  command->callback([&action, arguments] { action = [arguments] { return run(*arguments); }; });
}

}  // namespace plumb
