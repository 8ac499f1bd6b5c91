#pragma once

#include <vector>

#include "reference/algebraic_t.h"
#include "reference/exact_hit.h"

namespace plumb {

/// solid_hit with the inverse matrix in fractions, for a shape and ray within the oracle's domain. The line is cut at
/// every t where it meets a limit of the solid, and membership is decided at a fraction in each piece. `roots`, if not
/// null, receives the exact t of each crossing. Only for the .cpp files of this folder.
ExactHit rational_solid_hit(const PlacedShape& placed, const Ray& ray, std::vector<AlgebraicT>* roots = nullptr);

}  // namespace plumb
