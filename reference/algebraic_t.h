#pragma once

#include <gmpxx.h>

#include "reference/exact_hit.h"

namespace plumb {

/// A t as a root of a t^2 + b t + c = 0: `root` 0 is the smaller one, 1 the larger. With a = 0 it is -c / b. It must
/// have that root: b^2 >= 4 a c, or a = 0 and b != 0. For the oracle's own sources only.
struct AlgebraicT {
  mpq_class a = 0, b = 1, c = 0;
  int root = 0;
};

/// -1, 0 or 1 as x < y, x = y or x > y; exact.
int compare(const AlgebraicT& x, const AlgebraicT& y);

/// The exact t of a crossing that solid_hit returned for the same shape and ray. Two crossings whose every field agrees
/// (roots within one spacing of doubles) cannot be told apart: the nearer answers. Throws std::invalid_argument for a
/// crossing that is none of this ray.
AlgebraicT solid_crossing_t(const PlacedShape& shape, const Ray& ray, const ExactCrossing& crossing);

}  // namespace plumb
