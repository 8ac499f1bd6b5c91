#pragma once

#include <cstddef>

#include "meshes/triangle_mesh.h"

namespace plumb {

/// How much a triangle counts in the normal of its vertex.
enum class NormalWeight {
  kArea,   ///< by its area: sums, products and roots alone, so the same bits on every machine
  kAngle,  ///< by its angle at the vertex [Thürmer and Wüthrich 1998], by libm's atan2, whose last bit may differ
};

/// Gives each vertex the weighted mean of the normals of its triangles, of unit length. Triangles without area count
/// nothing. A vertex for which nothing is left, or whose triangles cancel, gets (0, 0, 1); returns how many.
std::size_t compute_normals(TriangleMesh& mesh, NormalWeight weight);

/// Repeats vertices so that triangles share one only where they are smooth there: where a chain of triangles around the
/// vertex joins them, each to the next across an edge at which their normals differ by `degrees` at most. New vertices
/// come last, with the place, normal and texture coordinate of the old. A triangle without area is smooth to every
/// neighbour. Requires 0 <= degrees <= 180. Returns how many vertices were added. Throws std::length_error past 2^32 -
/// 1 vertices.
std::size_t split_at_creases(TriangleMesh& mesh, double degrees);

/// Turns the mesh inside out: reverses the order of each triangle's vertices, and the normals.
void flip(TriangleMesh& mesh);

}  // namespace plumb
