#pragma once

#include "meshes/triangle_mesh.h"

namespace plumb {

/// Cuts each triangle in four and moves all vertices towards the smooth surface of Loop's scheme [Loop 1987], by
/// OpenMesh. Vertices keep their numbers, in front of the new ones; a boundary stays on the curve of its own vertices.
/// Texture coordinates of new vertices are the means of their edge's ends; normals are dropped, for the surface has
/// changed. The weights use the cosine of libm, so that the last bits may differ between machines.
///
/// Throws std::invalid_argument for a mesh with a manifold_fault, std::length_error where OpenMesh's int indices end.
TriangleMesh loop_subdivided(const TriangleMesh& mesh);

}  // namespace plumb
