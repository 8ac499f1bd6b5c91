#pragma once

#include <cstddef>
#include <functional>

#include "meshes/triangle_mesh.h"

namespace plumb {

struct Simplifying {
  /// How many triangles to keep at most.
  std::size_t triangles = 0;
  /// Told the share that is done, from 0 to 1; may be empty.
  std::function<void(double)> progress;
};

struct Simplified {
  TriangleMesh mesh;
  /// How far vertices are from what they stand for: for a vertex that took in others, the root of the mean, by area, of
  /// its squared distances to the planes of all triangles that were at them; the largest of these, in units of the
  /// mesh. Not a bound on the distance of the surfaces.
  double largest_error = 0;
};

/// Removes vertices one by one, the cheapest first, each moved along an edge into a neighbour, at the cost of the
/// squared distances to the planes of what it stands for [Garland and Heckbert 1997], by the decimater of OpenMesh.
/// What stays are vertices of the mesh, in their order, with their normals and texture coordinates. Boundaries stay
/// boundaries, and cost as if a wall stood on them. No triangle turns over by a right angle or more, and none loses its
/// area. The result may have more triangles than asked for, where none of the rest may go. The same mesh gives the same
/// result.
///
/// The two sides of a seam, where vertices are doubled for their texture coordinates, are two boundaries, which may
/// come apart.
///
/// Throws std::invalid_argument for a mesh with a manifold_fault. A mesh that has no more triangles than asked for is
/// returned as it is.
Simplified simplified(const TriangleMesh& mesh, const Simplifying& options);

}  // namespace plumb
