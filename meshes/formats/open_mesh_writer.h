#pragma once

#include <functional>
#include <ostream>
#include <string>

#include "meshes/triangle_mesh.h"

namespace plumb {

/// Writes a sound mesh of at most 2^31 - 1 vertices, whose numbers fit single precision, through the writer of OpenMesh
/// for `.obj`, `.ply` or `.off`, with its normals and texture coordinates. `text` chooses the text of the formats that
/// are binary otherwise. False if OpenMesh says that it failed.
bool write_with_open_mesh(const TriangleMesh& mesh, const std::string& ending, bool text, std::ostream& out,
                          const std::function<void(double)>& progress);

}  // namespace plumb
