#pragma once

#include <filesystem>
#include <functional>

#include "meshes/triangle_mesh.h"

namespace plumb {

/// Writes a mesh as the course's mesh text, one word or number a line with LF, numbers as the shortest
/// decimals that read back to the same bits: the same mesh gives the same bytes everywhere. The text goes
/// to a temporary file beside `file`, which is then renamed over it, so a reader never sees half a mesh.
/// `progress`, which may be empty, is told the share that is written.
/// Throws InputError if it cannot be written, std::invalid_argument for a mesh that read_msh would refuse:
/// an index out of range, a number that is not finite, normals or texcoords that are not one a vertex.
void write_msh(const TriangleMesh& mesh, const std::filesystem::path& file,
               const std::function<void(double)>& progress = {});

}  // namespace plumb
