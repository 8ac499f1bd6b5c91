#pragma once

#include <filesystem>
#include <string_view>

#include "meshes/mesh_notes.h"
#include "meshes/triangle_mesh.h"

namespace plumb {

/// Reads a PLY file as read_with_open_mesh says: text through OpenMesh, binary of either byte order straight into the
/// mesh, which is the same. `content` is that of a file; its name is for messages.
TriangleMesh read_ply(std::string_view content, const std::filesystem::path& file, MeshNotes& notes);

}  // namespace plumb
