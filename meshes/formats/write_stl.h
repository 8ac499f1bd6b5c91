#pragma once

#include <functional>
#include <ostream>

#include "meshes/triangle_mesh.h"

namespace plumb {

/// Writes the triangles of a sound mesh, in their order, as STL: binary, or text with as many digits as single
/// precision needs. Coordinates must fit single precision. The facet normals are those of the triangles' winding, with
/// unit length, and zeros for a triangle without area.
void write_stl(const TriangleMesh& mesh, bool text, std::ostream& out, const std::function<void(double)>& progress);

}  // namespace plumb
