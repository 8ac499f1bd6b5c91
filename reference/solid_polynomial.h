#pragma once

#include "reference/exact_hit.h"

namespace plumb {

/// How the numbers (not the decisions) of solid_hit are rounded: from balls around exact coefficients where these
/// decide, or always by exact signs. The results are the same.
enum class SolidRounding { balls_first, exact };

/// solid_hit without division, for a shape and ray within the oracle's domain: CGAL::Mpzf, which has no bound on
/// exponents, and square roots by comparing squares.
ExactHit polynomial_solid_hit(const PlacedShape& placed, const Ray& ray, SolidRounding rounding);

}  // namespace plumb
