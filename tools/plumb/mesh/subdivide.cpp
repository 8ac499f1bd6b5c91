#include "meshes/editing/subdivide.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "meshes/editing/loop_subdivide.h"
#include "meshes/editing/vertex_normals.h"
#include "meshes/read_mesh.h"
#include "renderer/math/input_error.h"
#include "tools/plumb/mesh/edit_arguments.h"
#include "tools/plumb/mesh/mesh_command.h"
#include "tools/plumb/progress_bar.h"

namespace plumb {
namespace {

/// A mesh file of tens of gigabytes: more is a slip of the hand.
constexpr std::size_t kMostTriangles = 400'000'000;

struct Arguments : EditArguments {
  int times = 1;
  bool smooth = false;
};

void check(const Arguments& a, std::size_t triangles) {
  if (a.times < 1 || a.times > 15)
    throw InputError({}, fmt::format("--times {}: expected a number from 1 to 15", a.times));
  const std::size_t wanted = triangles << (2 * a.times);
  if (triangles > kMostTriangles || wanted > kMostTriangles)
    throw InputError({a.in}, fmt::format("--times {} would make {} triangles; expected at most {}", a.times, wanted,
                                         kMostTriangles));
  if (a.smooth && wanted > 0x7fffffff / 6)
    throw InputError({a.in}, fmt::format("--times {} would make {} triangles; expected at most {} with --smooth",
                                         a.times, wanted, 0x7fffffff / 6));
}

int run(const Arguments& a) {
  TriangleMesh mesh = a.smooth ? read_manifold_mesh(a.in) : read_mesh(a.in);
  check(a, mesh.triangles.size());
  const bool had_normals = !mesh.normals.empty();
  {
    ProgressBar bar("subdividing");
    // Each time costs four times the last.
    double done = 0, step = 1, all = 0;
    for (int i = 0; i < a.times; ++i, step *= 4) all += step;
    step = 1;
    for (int i = 0; i < a.times; ++i, step *= 4) {
      mesh = a.smooth ? loop_subdivided(mesh) : subdivided(mesh);
      bar.show((done += step) / all);
    }
  }
  if (a.smooth && had_normals) compute_normals(mesh, NormalWeight::kArea);
  write_and_report(mesh, a.out, a.text);
  if (a.smooth && had_normals) fmt::print("normals: computed from the new triangles, by area\n");
  return 0;
}

}  // namespace

void add_mesh_subdivide(CLI::App& mesh, Action& action) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = add_edit_verb(mesh, "subdivide", "Cut each triangle in four", *arguments);
  command->add_option("--times", arguments->times, "How many times [1]")->type_name("K");
  command->add_flag("--smooth", arguments->smooth,
                    "Move the vertices towards the smooth surface of Loop's scheme [the shape stays]");
  command->callback([&action, arguments] { action = [arguments] { return run(*arguments); }; });
}

}  // namespace plumb
