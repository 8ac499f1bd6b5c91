#pragma once

#include <optional>
#include <string>

#include "meshes/triangle_mesh.h"

namespace plumb {

/// Why a half-edge structure cannot hold the mesh as it is, naming the first place that is wrong: a triangle with a
/// vertex twice, an edge that two triangles run through in the same direction (which every edge of three triangles
/// has), a vertex whose triangles form more than one fan. nullopt for a manifold mesh that is oriented, with or without
/// a boundary; vertices of no triangle do not matter.
std::optional<std::string> manifold_fault(const TriangleMesh& mesh);

}  // namespace plumb
