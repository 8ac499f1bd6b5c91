#include "meshes/editing/simplify.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "renderer/math/input_error.h"
#include "tools/plumb/mesh/edit_arguments.h"
#include "tools/plumb/mesh/mesh_command.h"
#include "tools/plumb/progress_bar.h"

namespace plumb {
namespace {

struct Arguments : EditArguments {
  std::size_t triangles = 0;
};

int run(const Arguments& a) {
  if (a.triangles == 0) throw InputError({}, "--triangles 0: expected a number of triangles from 1");
  const TriangleMesh mesh = read_manifold_mesh(a.in);
  Simplified result;
  {
    ProgressBar bar("simplifying");
    result = simplified(mesh, {.triangles = a.triangles, .progress = [&](double share) { bar.show(share); }});
  }
  write_and_report(result.mesh, a.out, a.text);
  const std::size_t reached = result.mesh.triangles.size();
  fmt::print("largest error: {:.6g} (root mean square distance of a vertex from the planes it stands for)\n",
             result.largest_error);
  if (reached > a.triangles)
    fmt::print(
        "{} triangles are left of {}, not {}: no further vertex can go without turning a triangle over or "
        "changing how the surface is connected\n",
        reached, mesh.triangles.size(), a.triangles);
  return 0;
}

}  // namespace

void add_mesh_simplify(CLI::App& mesh, Action& action) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = add_edit_verb(mesh, "simplify", "Remove vertices where the shape loses least", *arguments);
  command->add_option("--triangles", arguments->triangles, "How many triangles to keep at most")
      ->required()
      ->type_name("N");
  command->callback([&action, arguments] { action = [arguments] { return run(*arguments); }; });
}

}  // namespace plumb
