#pragma once

#include "meshes/triangle_mesh.h"

namespace plumb {

/// Throws std::invalid_argument for a mesh that no reader would give: an index out of range, a number that is not
/// finite, normals or texcoords that are not one a vertex.
void require_sound(const TriangleMesh& mesh);

}  // namespace plumb
