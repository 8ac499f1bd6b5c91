#pragma once

#include <gmpxx.h>

#include "reference/exact_hit.h"

namespace plumb {

/// An exact t: a root of a t^2 + b t + c. Only for the .cpp files of this folder.
struct AlgebraicT {
  mpq_class a, b, c;
  /// 0 the smaller root, 1 the larger; with a = 0 the one root of b t + c, b not zero.
  int root = 0;
};

/// The exact t of a crossing that solid_hit returned for the same shape and ray. Two crossings whose every field agrees
/// (roots within one spacing of doubles) cannot be told apart: the nearer answers. Throws std::invalid_argument for a
/// crossing that is none of this ray.
AlgebraicT solid_crossing_t(const PlacedShape& shape, const Ray& ray, const ExactCrossing& crossing);

}  // namespace plumb
