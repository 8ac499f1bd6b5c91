#pragma once

#include <optional>

#include "reference/exact_hit.h"

namespace plumb {

/// solid_hit by doubles with a derived bound (solid_ball.h), for a shape and ray within the oracle's domain; nothing if
/// any decision or any rounding is in doubt.
std::optional<ExactHit> filtered_solid_hit(const PlacedShape& placed, const Ray& ray);

}  // namespace plumb
