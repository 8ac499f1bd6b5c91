#pragma once

#include "renderer/accel/bvh8_layout.h"
#include "renderer/accel/candidates.h"
#include "renderer/accel/filter_ray.h"
#include "renderer/integrator/trace_counters.h"
#include "meshes/triangle_mesh.h"

namespace plumb {

/// Offers to `closest` each triangle that the ray may hit within what is left of its range, roughly near to far; with `any`,
/// until there is a hit. Compiled for several instruction sets; all offer the same triangles in the same order.
void walk_bvh8(const Bvh8Tree& tree, const TriangleMesh& mesh, FilterRay& ray, bool any, ClosestTriangle& closest,
               TraceCounters& counters);

}  // namespace plumb
