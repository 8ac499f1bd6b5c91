#pragma once

#include <filesystem>
#include <string>

#include "meshes/formats/prepare.h"
#include "meshes/mesh_notes.h"
#include "meshes/triangle_mesh.h"

namespace plumb {

/// Reads an OBJ or OFF file, by its ending, through the readers of OpenMesh. Vertices, faces and their order are kept
/// as in the file, non-manifold or not; a face of more than three corners becomes a fan around its first. Numbers have
/// single precision, which is all that OpenMesh reads of them.
///
/// Normals and texture coordinates are kept where every vertex has them. In OBJ they belong to the corners
/// of faces: a vertex whose corners disagree is repeated behind the vertices of the file, once for each
/// further pair that its corners have; they are kept where every corner has them, and a vertex of no face
/// gets zeros. What is left out, and repeated vertices, stand in the notes.
///
/// Throws InputError for what the preparation in `prepare.h` refuses. Reads one file at a time, because the
/// readers of OpenMesh are global objects; other threads wait.
///
/// `content` is that of a file; its name gives the ending, and is for messages. An OFF file has to be there, because
/// OpenMesh opens it to learn its kind.
TriangleMesh read_with_open_mesh(std::string content, const std::filesystem::path& file, MeshNotes& notes);
/// The same for a file that has been prepared, also PLY.
TriangleMesh read_with_open_mesh(PreparedMesh prepared, const std::filesystem::path& file, MeshNotes& notes);

}  // namespace plumb
