#pragma once

#include "meshes/triangle_mesh.h"
#include "renderer/accel/bvh8_layout.h"

namespace plumb {

struct Bvh8Options {
  /// How many threads may build. What rays find does not depend on it.
  int threads = 1;
};

/// The hierarchy of a mesh. Triangles with a number that is not finite are left out: no ray hits them.
Bvh8Tree build_bvh8(const TriangleMesh& mesh, const Bvh8Options& options);

}  // namespace plumb
