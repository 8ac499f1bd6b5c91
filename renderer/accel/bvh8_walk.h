#pragma once

#include <memory>
#include <optional>

#include "renderer/accel/bvh8_layout.h"
#include "renderer/integrator/trace_counters.h"
#include "renderer/math/placed_ray.h"
#include "renderer/surfaces/closest_triangle.h"

namespace plumb {

/// A tree and what it was built from.
struct SearchedMesh {
  std::shared_ptr<const TriangleMesh> mesh;
  Bvh8Tree tree;
  /// As in ClosestTriangle.
  double largest_coordinate = 0;
  /// Of the weights, as there, by a ray without errors whose origin is near the tree, in doubles.
  double near_weight_error = 0;
};

/// Bvh8::closest and any, for one instruction set; all visit the same nodes and give the same hits.
struct Bvh8Walks {
  std::optional<SurfaceHit> (*closest)(const SearchedMesh&, const PlacedRay&, TraceCounters&);
  bool (*any)(const SearchedMesh&, const PlacedRay&, TraceCounters&);
};

/// Those of the best instruction set that Highway's chosen target allows.
Bvh8Walks bvh8_walks();

}  // namespace plumb
