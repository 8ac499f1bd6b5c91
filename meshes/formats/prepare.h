#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "meshes/mesh_notes.h"

namespace plumb {

/// A mesh file in a plain form that OpenMesh reads right. OpenMesh itself passes over what it does not
/// understand, allocates what a header claims, stops the program on some faces, and opens files that an
/// OBJ names; so each file is checked and reduced to its geometry first.
struct PreparedMesh {
  std::string bytes;
  std::size_t vertices = 0;
  /// How many faces OpenMesh must report; fewer means that it dropped one.
  std::size_t faces = 0;
  /// How many triangles the faces become.
  std::size_t triangles = 0;
  /// Whether `bytes` are the format's binary variant.
  bool binary = false;
  /// OpenMesh drops a corner whose vertex the face has already. So `bytes` have further vertices behind the `vertices`
  /// of the file, one for each such corner: the vertex that is meant.
  std::vector<std::uint32_t> stand_ins;
  /// What has been left out.
  MeshNotes notes;
};

/// Each takes the content and the name of a file, the name for messages only. Throws InputError, with line
/// and column where the file is text, for contents that are not the format, numbers that are not finite or
/// do not fit single precision, counts that the file is too short for, vertex indices out of range, and faces
/// of less than three corners.

/// Keeps v, vt (two numbers), vn and f; other statements are left out. Refuses a face of more than 1000 corners.
PreparedMesh prepare_obj(const std::string& content, const std::string& file);
/// Keeps x y z, nx ny nz, u v (or s t, texture_u texture_v) and vertex_indices, whatever their types and
/// byte order, as binary little-endian float and int.
PreparedMesh prepare_ply(std::string_view content, const std::string& file);
/// Keeps coordinates, normals (N) and texture coordinates (ST); text, or binary in OpenMesh's own form,
/// which is little-endian. Takes the content over.
PreparedMesh prepare_off(std::string&& content, const std::string& file);

}  // namespace plumb
