#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "meshes/validation/mesh_report.h"

namespace plumb {

/// Fills in what edges tell: edges, duplicate triangles, the four faults of edges and fans, closed, manifold, oriented,
/// components and the Euler characteristic. `place_of` as of MeshPlaces; triangles with two corners at one place are
/// left out. Half-edges are sorted, nothing is hashed: 40 bytes a triangle.
void check_topology(const TriangleMesh& mesh, std::span<const std::uint32_t> place_of,
                    const std::function<void(double)>& progress, MeshReport& report);

}  // namespace plumb
