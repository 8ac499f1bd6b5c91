#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace plumb {

/// What a reader found in a mesh file beside the mesh.
struct MeshNotes {
  /// The format and its variant: "PLY, binary, little-endian".
  std::string format;
  /// Faces of more than three corners, each cut into a fan of triangles around its first corner.
  std::size_t polygons = 0;
  /// What the file holds and the mesh does not, or has otherwise: a sentence each, with counts. Empty if the mesh is
  /// all that the file says.
  std::vector<std::string> sentences;
};

/// "1 vertex", "12 vertices".
std::string counted(std::size_t count, const std::string& one, const std::string& many);

}  // namespace plumb
