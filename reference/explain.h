#pragma once

#include <string>
#include <vector>

#include "reference/exact_hit.h"
#include "reference/exact_transform.h"
#include "renderer/math/bounds3.h"

namespace plumb {

/// An exact number on the way to an answer, in words for people.
struct ExplainedNumber {
  std::string name;      ///< `U`
  std::string formula;   ///< `d . (C x B)`
  std::string fraction;  ///< exact, `p/q`; with a square root as `(p + s sqrt(q)) / a`; empty for a transcendental one
  std::string decimal;   ///< to 30 digits
  int sign = 0;
};

/// What decides an answer, in the order in which it is used, and the answer.
struct Explanation {
  std::vector<ExplainedNumber> numbers;
  /// One sentence a step: which sign decided what.
  std::vector<std::string> steps;
};

/// The determinants of a triangle, the quadratic of a round surface, the slabs of a box, for this ray, in the shape's
/// own frame (the ray is taken there exactly; t does not change). Throws std::invalid_argument for a mesh, a shape
/// outside of the oracle's domain, and a singular matrix.
Explanation explain_ray(const PlacedShape& shape, const Ray& ray);

/// Number by number, the exact faces of the world box.
Explanation explain_bounds(const PlacedShape& shape);

/// The exact value of a double: `0x1.8p+0 = 3/2 = 1.5`.
std::string exact_text(double value);

}  // namespace plumb
