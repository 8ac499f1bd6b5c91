#include "tools/plumb/mesh/edit_arguments.h"

#include <CLI/CLI.hpp>

#include "meshes/editing/manifold.h"
#include "meshes/read_mesh.h"
#include "renderer/math/input_error.h"

namespace plumb {

CLI::App* add_edit_verb(CLI::App& mesh, const char* verb, const char* help, EditArguments& arguments) {
  CLI::App* command = mesh.add_subcommand(verb, help);
  command->add_option("IN", arguments.in, "Mesh file (.msh, .obj, .ply, .off, .stl)")->required();
  command->add_option("OUT", arguments.out, "Mesh file to write, in the format that its ending names")->required();
  command->add_flag("--text", arguments.text, "Write text where the format also has a binary form");
  return command;
}

TriangleMesh read_manifold_mesh(const std::string& file) {
  TriangleMesh mesh = read_mesh(file);
  if (const auto fault = manifold_fault(mesh))
    throw InputError(
        {file},
        *fault +
            "; expected a manifold mesh whose triangles agree in their orientation (`plumb mesh check` says more)");
  return mesh;
}

}  // namespace plumb
