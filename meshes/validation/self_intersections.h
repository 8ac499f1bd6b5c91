#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "meshes/validation/mesh_report.h"

namespace plumb {

/// The triangles that intersect another one beyond what they share. Decided exactly. Corners at one place (`place_of`
/// as of MeshPlaces) are one vertex, whatever their indices, so that a seam is not an intersection. A pair counts
///   that shares no vertex, if it has a point in common, be it a single one where they touch;
///   that shares a vertex, if it has a point in common beside it;
///   that shares an edge, if it lies in one plane on the same side of that edge;
///   that shares three vertices, always.
/// Triangles of zero area have no surface that could intersect another (MeshReport counts them) and are passed over.
/// Any mesh will do; the time grows with the number of pairs whose boxes overlap. 80 bytes a triangle.
MeshFault self_intersections(const TriangleMesh& mesh, std::span<const std::uint32_t> place_of,
                             const std::function<void(double)>& progress);

}  // namespace plumb
