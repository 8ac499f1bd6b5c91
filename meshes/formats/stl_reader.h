#pragma once

#include <string>

#include "meshes/mesh_notes.h"
#include "meshes/triangle_mesh.h"

namespace plumb {

/// Reads an STL file, text or binary: its facets in their order, of all its solids. Numbers have single precision.
/// STL shares no vertices: corners at equal points (0 equals -0) become one vertex, in the order of first use. Facet
/// normals, attributes and names are not kept. Throws InputError, with line and column where the file is text, for
/// contents that are not STL and for corners that are not finite or do not fit single precision.
/// `content` is that of a file; its name is for messages.
TriangleMesh read_stl(const std::string& content, const std::string& file, MeshNotes& notes);

}  // namespace plumb
