#pragma once

#include <filesystem>
#include <string>

#include "meshes/mesh_notes.h"
#include "meshes/triangle_mesh.h"

namespace plumb {

/// Reads a mesh file in the format that its ending names, in any case: `.msh` as read_msh does, `.ply` as read_ply
/// does, `.stl` as read_stl does, `.obj` and `.off` as read_with_open_mesh does. In the result every index is below the
/// number of vertices and every number is finite. Throws InputError for another ending, a file that cannot be read, and
/// contents that are not what the format says; no size in a file makes it allocate more than a small multiple of the
/// file's length. `notes`, if given, is set to what the file says beside the mesh. A `.msh` or `.ply` file is mapped
/// into memory while it is read, and must not be made shorter meanwhile (see MappedFile).
TriangleMesh read_mesh(const std::filesystem::path& file, MeshNotes* notes = nullptr);
/// The same for the content of a file; its name gives the ending, and is for messages. An OFF file has to be there,
/// because OpenMesh opens it to learn its kind.
TriangleMesh parse_mesh(std::string content, const std::filesystem::path& file, MeshNotes* notes = nullptr);

}  // namespace plumb
