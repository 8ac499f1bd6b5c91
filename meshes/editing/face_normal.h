#pragma once

#include <array>
#include <cstdint>

#include "meshes/triangle_mesh.h"

namespace plumb {

/// A power of two that brings the largest coordinate near 1, so that products of edges neither overflow nor vanish.
/// 1 for a mesh of zeros.
double coordinate_scale(const TriangleMesh& mesh);

/// The edge from one vertex to another, scaled.
Vec3 scaled_edge(const TriangleMesh& mesh, std::uint32_t from, std::uint32_t to, double scale);

/// The cross product of two edges, towards the triangle's front; its length is twice the area, scaled. Zero if the
/// triangle has none.
Vec3 scaled_face_normal(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& triangle, double scale);

}  // namespace plumb
