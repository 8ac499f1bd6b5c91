#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "meshes/formats/ply_header.h"
#include "meshes/mesh_notes.h"

namespace plumb {

/// What of a vertex is kept, in the order in which it is handed on: x y z, nx ny nz, u v.
inline constexpr std::size_t kPlyVertexNumbers = 8;
inline constexpr std::size_t kPlyNormal = 3, kPlyTexcoord = 6;

/// Which elements and properties of a PLY file become the mesh. Points into the header.
struct PlyLayout {
  const PlyElement* vertex = nullptr;
  /// Null if there are none.
  const PlyElement* face = nullptr;
  /// The property of each number of a vertex: all three coordinates, all three of a normal or none, both texture
  /// coordinates or none.
  std::array<std::optional<std::size_t>, kPlyVertexNumbers> sources;
  /// The list of a face's corners; there is one unless there are no faces.
  std::optional<std::size_t> corners;

  /// The place among the numbers of a vertex that a property of it has; kPlyVertexNumbers if it is not kept.
  std::size_t slot_of(std::size_t property) const;
};

/// Throws InputError at the header's words where the file cannot be a mesh.
PlyLayout find_ply_layout(const PlyHeader& header, const TextCursor& cursor);

/// The format, and what of the file is left out; `polygons`, and that `rounded` numbers were rounded, included.
MeshNotes ply_notes(const PlyHeader& header, const PlyLayout& layout, std::size_t polygons, std::size_t rounded);

}  // namespace plumb
