#pragma once

#include "meshes/triangle_mesh.h"
#include "renderer/math/bounds3.h"
#include "renderer/math/transform.h"

namespace plumb {

/// Whether a map turns a left hand into a right one: the sign of its determinant is negative. Exact for entries that
/// are zero or at least 2^-280 of the largest of their row.
bool is_mirroring(const AffineMatrix& matrix);

/// The mesh moved. Normals go by the inverse transpose and are made unit; one without a length stays zero. A mirroring
/// map also reverses the order of each triangle's vertices, so that its front stays on the outside. Texture coordinates
/// stay. Throws std::range_error where a place leaves the range of doubles.
TriangleMesh transformed(TriangleMesh mesh, const Transform& world_from_object);

/// The box around all vertices, used or not, where the matrix takes them; empty for a mesh without vertices.
Bounds3 bounds_of(const TriangleMesh& mesh, const AffineMatrix& world_from_object);

/// The map that moves the middle of a box to the origin and makes its longest side 1, and so takes it into the cube
/// from -1/2 to 1/2, to within rounding. Requires a box that is not a point, with sides that are finite.
AffineMatrix unit_cube_from(const Bounds3& box);

}  // namespace plumb
