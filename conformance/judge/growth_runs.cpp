#include "conformance/judge/growth_runs.h"

#include <fmt/format.h>
#include <stdlib.h>

#include <cerrno>
#include <chrono>
#include <cmath>
#include <fstream>
#include <iterator>
#include <system_error>

#include "conformance/growth/growth_picture.h"
#include "conformance/judge/build_submission.h"
#include "conformance/judge/commands.h"
#include "conformance/judge/stop_verdict.h"
#include "conformance/sandbox/harvest.h"
#include "conformance/sandbox/run_process.h"
#include "meshes/editing/subdivide.h"
#include "meshes/write_mesh.h"
#include "renderer/build_scene.h"
#include "renderer/image/staged_file.h"
#include "renderer/kinds.h"
#include "renderer/math/input_error.h"
#include "scenes/load_meshes.h"
#include "scenes/read_scene.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr double kSmallest = 1000;
/// The scene with next to nothing in it: a corner of the mesh, or so many balls.
constexpr std::size_t kStartTriangles = 12;
constexpr double kStartBalls = 8;

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError({file.string()}, "cannot read the template");
  return {std::istreambuf_iterator<char>(stream), {}};
}

TriangleMesh first_triangles(TriangleMesh mesh, std::size_t count) {
  mesh.triangles.resize(count);
  std::uint32_t most = 0;
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t index : triangle) most = std::max(most, index);
  mesh.positions.resize(most + 1);
  mesh.normals.resize(most + 1);
  return mesh;
}

}  // namespace

GrowthRunner::GrowthRunner(const SuiteCase& suite_case, std::uint64_t seed, const Runner& runner, Workspace& workspace)
    : suite_case_(suite_case), runner_(runner), workspace_(workspace), seed_(seed), names_(seed, "growth-names", 0) {
  std::string name = (fs::temp_directory_path() / "plumb-growth-XXXXXX").string();
  if (!::mkdtemp(name.data())) throw std::system_error(errno, std::generic_category(), "cannot make " + name);
  folder_ = fs::canonical(name);
  if (of_objects()) {
    for (double side = 10; sizes_.empty() || sizes_.back() < suite_case.growth.largest; side *= std::cbrt(4))
      sizes_.push_back(std::pow(std::round(side), 3));
  } else {
    make_meshes();
  }
}

GrowthRunner::~GrowthRunner() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

void GrowthRunner::make_meshes() {
  TriangleMesh mesh = growth_mesh(seed_);
  const TriangleMesh start = first_triangles(mesh, kStartTriangles);
  const auto add = [&](const TriangleMesh& one) {
    meshes_.push_back(folder_ / fmt::format("{}.{}", meshes_.size(), suite_case_.growth.mesh_format));
    write_mesh(one, meshes_.back(), {.text = true, .progress = nullptr});
  };
  for (;; mesh = subdivided(mesh)) {
    sizes_.push_back(static_cast<double>(mesh.triangles.size()));
    add(mesh);
    if (sizes_.back() >= suite_case_.growth.largest) break;
  }
  add(start);
}

std::string GrowthRunner::objects(const GrowthQuestion& question, const std::string& object_template) const {
  std::string text;
  for (const GrowthBall& ball : growth_balls(question.size ? sizes_[*question.size] : kStartBalls, seed_))
    text += filled_template(object_template, ball_names(ball)) + "\n";
  return text;
}

GrowthNames GrowthRunner::names_of(const GrowthQuestion& question, const std::string& mesh,
                                   const std::string& object_template) const {
  GrowthNames names =
      camera_names(growth_camera(question.view, question.round, seed_), question.width, question.height);
  names["mesh"] = mesh;
  if (of_objects()) names["objects"] = objects(question, object_template);
  return names;
}

void GrowthRunner::write_scene(const fs::path& file, const fs::path& from, const GrowthNames& names) const {
  std::ofstream stream(file, std::ios::binary);
  stream << filled_template(text_of(from), names);
  stream.close();
  if (!stream) throw std::system_error(errno, std::generic_category(), "cannot write " + file.string());
}

/// Nothing that a program could know a size by.
std::string GrowthRunner::random_name() {
  std::string name;
  for (int i = 0; i < 10; ++i) name += static_cast<char>('a' + names_.below(26));
  return name;
}

GrowthAnswer GrowthRunner::run(const GrowthQuestion& question) {
  const Clock::time_point begin = Clock::now();
  SuiteCase one = suite_case_;
  const std::string ending = suite_case_.scene.stem().extension().string();  // mesh.xml.in, or mesh.xml
  one.scene = folder_ / (random_name() + (ending.empty() ? suite_case_.scene.extension().string() : ending));
  one.inputs = {one.scene};
  std::string mesh;
  if (!of_objects()) {
    mesh = random_name() + "." + suite_case_.growth.mesh_format;
    one.inputs.push_back(folder_ / mesh);
    fs::create_hard_link(meshes_[question.size.value_or(sizes_.size())], folder_ / mesh);
  }
  write_scene(one.scene, suite_case_.growth.scene, names_of(question, mesh, suite_case_.growth.object));
  const Workspace::CaseFolder folder = workspace_.make_case_folder(one, runner_);
  for (const fs::path& input : one.inputs) fs::remove(input);

  CasePaths paths = case_paths(runner_, one);
  paths.width = question.width, paths.height = question.height;
  ProcessRequest request;
  request.arguments = render_command(runner_, paths);
  request.folder = folder.run;
  request.environment = environment(runner_, folder.home);
  request.writable_folder = folder.all;
  std::int64_t input_bytes = 0;
  for (const fs::path& input : one.inputs)
    input_bytes += static_cast<std::int64_t>(fs::file_size(folder.run / paths.folder / input.filename()));
  request.limits = {.cpu_seconds = suite_case_.cpu_seconds,
                    .wall_seconds = suite_case_.wall_seconds,
                    .memory_bytes = suite_case_.memory_mb << 20,
                    .output_bytes = (suite_case_.output_mb << 20) + input_bytes};
  const RunOutcome run = run_process(request);
  log_ = run.log;
  GrowthAnswer answer{.cpu_seconds = run.cpu_seconds, .wall_seconds = 0};
  answer.over_limit = run.reason == StopReason::cpu_limit || run.reason == StopReason::wall_limit;
  if (!answer.over_limit) {
    if (const auto stop = verdict_of_stop(one, run, false)) throw GrowthStop(*stop);
    if (!workspace_.check_build())
      throw GrowthStop(stopped(Verdict::security, "build_changed",
                               "the program changed its own build, which later runs would have used",
                               "write only beside the scene or where the assignment says"));
    check_picture(question, run, folder.run, paths.output);
  }
  workspace_.remove_case_folder(folder);
  answer.wall_seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  return answer;
}

void GrowthRunner::check_picture(const GrowthQuestion& question, const RunOutcome& run, const fs::path& run_folder,
                                 const std::string& output) {
  const fs::path picture = folder_ / ("picture" + fs::path(output).extension().string());
  const HarvestResult harvested = harvest(run_folder, output, suite_case_.output_mb << 20, picture);
  if (harvested.status == HarvestStatus::missing)
    throw GrowthStop(
        stopped(Verdict::fail, "no_picture",
                run.reason == StopReason::cannot_start
                    ? run.start_error
                    : fmt::format("the program wrote no picture and ended with exit status {}", run.exit_code),
                "read log.txt for what the program said, and check where it writes its picture"));
  if (harvested.status != HarvestStatus::copied)
    throw GrowthStop(stopped(Verdict::security, "link", harvested.sentence, "the picture must be an ordinary file"));
  // The surface is the same in every size, so the coarsest mesh makes the reference.
  const fs::path file = folder_ / "reference.xml";
  const std::string mesh = of_objects() ? "" : meshes_[question.size ? 0 : sizes_.size()].filename().string();
  write_scene(file, suite_case_.growth.reference_scene, names_of(question, mesh, suite_case_.growth.reference_object));
  const SceneDescription description = read_scene(file, renderer_kinds(dialect_named("pa3-2011")));
  std::vector<std::string> warnings;
  const Scene scene = build_scene(description, load_meshes(description), {}, warnings);
  const CheckResult result = check_growth_picture(
      picture, scene, {suite_case_.growth.tolerance, suite_case_.growth.wrong_share}, names_.bits());
  if (!is_right(result.verdict)) throw GrowthStop(result);
}

}  // namespace plumb
