#pragma once

#include <optional>

#include "renderer/accel/bvh8_layout.h"
#include "renderer/integrator/trace_counters.h"
#include "renderer/math/placed_ray.h"
#include "renderer/surfaces/closest_triangle.h"

namespace plumb {

/// A tree and what it was built from.
struct SearchedMesh {
  const Bvh8Tree& tree;
  const TriangleMesh& mesh;
  /// As in ClosestTriangle.
  double largest_coordinate;
};

/// As Bvh8::closest and any. Compiled for several instruction sets, of which the best is taken; all visit the same
/// nodes and give the same hits.
std::optional<SurfaceHit> closest_in_bvh8(const SearchedMesh& searched, const PlacedRay& ray, TraceCounters& counters);
bool any_in_bvh8(const SearchedMesh& searched, const PlacedRay& ray, TraceCounters& counters);

}  // namespace plumb
