#pragma once

#include "meshes/triangle_mesh.h"

namespace plumb {

/// Cuts each triangle in four at the midpoints of its edges, in its own plane: the shape stays as it was. A midpoint
/// that triangles share by the indices of its edge is one vertex. Normals and texture coordinates of a midpoint are the
/// means of its edge's ends, not made unit, so that what is interpolated over a face stays as it was too. A midpoint is
/// exact where the sum of two coordinates is. Works on any mesh, manifold or not. Throws std::length_error where the
/// vertices or triangles would pass 2^32 - 1.
TriangleMesh subdivided(const TriangleMesh& mesh);

}  // namespace plumb
