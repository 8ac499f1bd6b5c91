#pragma once

#include <filesystem>
#include <string>

#include "meshes/triangle_mesh.h"
#include "meshes/write_mesh.h"

namespace plumb {

/// What a file of the format that `ending` names (`.obj`, `.ply`, `.off`, `.stl`) will not hold of a sound mesh. Throws
/// InputError, with the file, for a number or a count that the format has no room for.
MeshLosses losses_of(const TriangleMesh& mesh, const std::string& ending, const std::filesystem::path& file);

}  // namespace plumb
