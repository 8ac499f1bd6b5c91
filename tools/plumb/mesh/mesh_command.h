#pragma once

#include "meshes/triangle_mesh.h"
#include "tools/plumb/command.h"

namespace plumb {

/// Each adds its verb below `plumb mesh`.
void add_mesh_info(CLI::App& mesh, Action& action);
void add_mesh_check(CLI::App& mesh, Action& action);
void add_mesh_convert(CLI::App& mesh, Action& action);
void add_mesh_generate(CLI::App& mesh, Action& action);
void add_mesh_simplify(CLI::App& mesh, Action& action);
void add_mesh_subdivide(CLI::App& mesh, Action& action);
void add_mesh_transform(CLI::App& mesh, Action& action);
void add_mesh_normals(CLI::App& mesh, Action& action);

/// Writes the mesh with a bar on a terminal, and prints `FILE: 642 vertices, 1280 triangles`, and what the format could
/// not carry, a line each.
void write_and_report(const TriangleMesh& mesh, const std::string& file, bool text);

}  // namespace plumb
