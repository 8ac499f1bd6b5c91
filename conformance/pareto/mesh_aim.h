#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "conformance/families/random.h"
#include "conformance/kernel/plumb_kernel.h"
#include "meshes/triangle_mesh.h"
#include "renderer/math/ray.h"

namespace plumb {

/// What of a mesh a ray is aimed at.
enum class MeshAim { vertices, edges, faces };
std::string_view to_string(MeshAim aim);

/// A vertex of the mesh, or a point on an edge or inside of a face, up to rounding.
Point3 aimed_point(Random& random, const TriangleMesh& mesh, MeshAim aim);

/// Rays from strictly inside of a closed mesh that is seen whole from its middle (closed_meshes), d = rounded(P - o).
/// Origins lie up to 0.7 of the way from the middle out. The n-th ray depends on name, aim, seed and n alone.
std::vector<Ray> rays_from_inside(const std::string& name, const TriangleMesh& mesh, MeshAim aim, std::uint64_t seed,
                                  std::size_t count, plumb_precision precision);

/// The same from outside, from the sphere of three half diagonals around the middle: half of them see what they aim at
/// from behind.
std::vector<Ray> rays_from_outside(const std::string& name, const TriangleMesh& mesh, MeshAim aim, std::uint64_t seed,
                                   std::size_t count, plumb_precision precision);

/// edge_margin of a ray at one triangle of a mesh, in units of a precision.
double mesh_margin(const Ray& ray, const TriangleMesh& mesh, std::uint32_t triangle, plumb_precision precision);

}  // namespace plumb
