#include "tools/plumb/mesh/mesh_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "meshes/write_mesh.h"
#include "tools/plumb/progress_bar.h"

namespace plumb {

void write_and_report(const TriangleMesh& mesh, const std::string& file, bool text) {
  MeshLosses losses;
  {
    ProgressBar bar("writing");
    losses = write_mesh(mesh, file, {.text = text, .progress = [&](double share) { bar.show(share); }});
  }
  fmt::print("{}: {} vertices, {} triangles\n", file, mesh.positions.size(), mesh.triangles.size());
  for (const std::string& sentence : losses.sentences) fmt::print("not carried: {}\n", sentence);
}

void add_mesh_command(CLI::App& app, Action& action) {
  CLI::App* mesh = app.add_subcommand("mesh", "Look at, certify, make, convert and change triangle meshes");
  mesh->require_subcommand(1);
  add_mesh_info(*mesh, action);
  add_mesh_check(*mesh, action);
  add_mesh_convert(*mesh, action);
  add_mesh_generate(*mesh, action);
  add_mesh_simplify(*mesh, action);
  add_mesh_subdivide(*mesh, action);
  add_mesh_transform(*mesh, action);
  add_mesh_normals(*mesh, action);
}

}  // namespace plumb
