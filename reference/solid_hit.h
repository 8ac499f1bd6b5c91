#pragma once

#include "reference/exact_hit.h"
#include "reference/stage_counters.h"

namespace plumb {

/// exact_hit() for all kinds but triangles and meshes. For the oracle's own sources only.
ExactHit solid_hit(const PlacedShape& shape, const Ray& ray, ExactPath path, StageCounters& counters);

}  // namespace plumb
