#pragma once

#include "reference/exact_hit.h"
#include "reference/quotient.h"
#include "reference/stage_counters.h"

namespace plumb {

/// exact_hit() for triangles and meshes. For the oracle's own sources only.
ExactHit triangle_hit(const PlacedShape& shape, const Ray& ray, ExactPath path, StageCounters& counters);

/// The exact t of a crossing that triangle_hit() returned for this shape and ray.
Quotient triangle_crossing_t(const PlacedShape& shape, const Ray& ray, const ExactCrossing& crossing);

}  // namespace plumb
