#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "meshes/triangle_mesh.h"

namespace plumb {

struct MeshWriting {
  /// Text where the format has both (PLY, STL, OFF): the default is binary.
  bool text = false;
  /// Told the share that is written, from 0 to 1; may be empty.
  std::function<void(double)> progress;
};

/// What the file does not hold of the mesh, a sentence each with counts ("normals of 642 vertices: STL has none of
/// vertices"; "12 of 1926 coordinates rounded to single precision, by at most 2.9e-08"). Empty if reading it gives the
/// same mesh.
struct MeshLosses {
  std::vector<std::string> sentences;
};

/// Throws the InputError of a file whose ending names no mesh format. Asked before long work.
void require_mesh_ending(const std::filesystem::path& file);

/// Writes a mesh in the format that the file's ending names (`.msh`, `.obj`, `.ply`, `.off`, `.stl`): `.msh` by
/// write_msh, `.stl` by write_stl, the others through the writers of OpenMesh; all but `.msh` in single precision. The
/// same mesh gives the same bytes everywhere. The bytes go to a temporary file beside `file`, which is then renamed
/// over it. Throws InputError for another ending, a file that cannot be written and a number that does not fit single
/// precision where the format has that, and std::invalid_argument for a mesh that is not sound, as write_msh.
MeshLosses write_mesh(const TriangleMesh& mesh, const std::filesystem::path& file, const MeshWriting& options = {});

}  // namespace plumb
