#pragma once

#include <memory>
#include <string>

#include "meshes/triangle_mesh.h"

namespace CLI {
class App;
}

namespace plumb {

/// What every verb that changes a mesh is told.
struct EditArguments {
  std::string in, out;
  bool text = false;
};

/// Adds a verb with its IN, OUT and --text, which live as long as `arguments` does.
CLI::App* add_edit_verb(CLI::App& mesh, const char* verb, const char* help, EditArguments& arguments);

/// The mesh in a file. Throws InputError, which names the first place that is wrong, unless it is manifold and
/// oriented.
TriangleMesh read_manifold_mesh(const std::string& file);

}  // namespace plumb
