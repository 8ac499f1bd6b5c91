#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "meshes/formats/ply_layout.h"
#include "meshes/triangle_mesh.h"

namespace plumb {

/// Plain copies out of the body of a binary PLY file, for the forms that large files have. They take only what is
/// right; whatever is not of such a form, or is wrong, is left for PlyRecords to take or to refuse.

/// Copies all vertices from `body`, which begins with them, into the lists of the mesh, which must have their lengths,
/// rounded to single precision. For vertices without lists, whose coordinates are all floats or all doubles, and so the
/// normals and the texture coordinates. Returns how many numbers were rounded; nullopt if it did not do all of it.
std::optional<std::size_t> copy_ply_vertices(const PlyHeader& header, const PlyLayout& layout, std::string_view body,
                                             TriangleMesh& mesh);

/// Appends the triangles that `body` begins with, at most `faces`, up to the first face that is none, has a wrong
/// vertex or is cut off. For faces of one list of 32-bit vertices with lengths of 8 or 32 bits; of others it takes
/// none. Returns how many bytes it took.
std::size_t copy_ply_triangles(const PlyHeader& header, const PlyLayout& layout, std::string_view body,
                               std::uint32_t faces, TriangleMesh& mesh);

}  // namespace plumb
