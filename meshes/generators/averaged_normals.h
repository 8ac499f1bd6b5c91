#pragma once

#include <vector>

#include "meshes/triangle_mesh.h"

namespace plumb {

/// A unit normal a vertex: the average of the normals of its triangles, weighted by their areas. Where that is nearly
/// behind one of them (at a sharp spike of a coarse mesh), it is `sure(position)`, a unit vector that is in front of
/// all triangles there. Requires that each vertex has a triangle and that none has zero area.
std::vector<Normal3> averaged_normals(const TriangleMesh& mesh, Normal3 (*sure)(const Point3& position));

}  // namespace plumb
