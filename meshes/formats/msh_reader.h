#pragma once

#include <string>
#include <string_view>

#include "meshes/mesh_notes.h"
#include "meshes/triangle_mesh.h"

namespace plumb {

/// Reads the course's mesh text: the number of vertices, the number of triangles, then the sections
/// `vertices` (three coordinates a vertex), `triangles` (three vertex indices from 0) and, at will,
/// `texcoords` (two numbers a vertex) and `normals` (three), in any order, each at most once. Words are
/// separated by any white space; numbers are decimal, with or without a sign, and keep double precision.
/// Both counts may be 0. Throws InputError with the line and column of the first word that is wrong.
/// Nothing is left out, so the notes have only the format. `text` is the content of a file; its name is for messages.
TriangleMesh read_msh(std::string_view text, const std::string& file, MeshNotes& notes);

}  // namespace plumb
