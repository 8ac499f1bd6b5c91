#pragma once

#include <vector>

#include "reference/shape.h"

namespace plumb {

/// Throws std::invalid_argument if a number that the shape uses, or one of the matrix, is outside of the oracle's
/// domain (see Shape). A mesh is outside if it is absent, or a triangle names a vertex that is not there; the vertices
/// that no triangle uses may be anything.
void require_bounded(const PlacedShape& placed);

/// The vertices of a mesh that a triangle uses, each once, in the order of the mesh.
std::vector<Point3> used_vertices(const TriangleMesh& mesh);

/// A row of the matrix (or its negative): x = row[0..2] . p + row[3] is one world coordinate of the point p.
using Row = std::array<double, 4>;

}  // namespace plumb
