#pragma once

#include <array>
#include <span>

#include "reference/exact_hit.h"
#include "renderer/math/transform.h"

namespace plumb {

/// One line of a group: what it does and by how much.
struct TransformStep {
  enum class Kind { translate, rotate, scale } kind = Kind::translate;
  /// Units of the scene; degrees about x, y, z (applied in this order: Rz Ry Rx).
  Vec3 value;
};

/// An enclosure for each entry of the upper three rows, row by row.
using EnclosedMatrix = std::array<std::array<Enclosure, 4>, 3>;
using EnclosedMatrix3 = std::array<std::array<Enclosure, 3>, 3>;

/// The cosine and sine of an angle in degrees, exactly enclosed. NaN for an angle that is not finite.
struct EnclosedCosSin {
  Enclosure cos, sin;
};
EnclosedCosSin certified_cos_sin(double degrees);

/// The product of the steps in file order (the first is outermost), true values: MPFR intervals, the precision doubled
/// from 256 to 2048 bits until each entry's neighbours are decided, then the two nearest doubles stand (a tie accepts
/// either).
EnclosedMatrix certified_product(std::span<const TransformStep> steps);
/// The product of matrices whose doubles are exact, left to right; each entry enclosed.
EnclosedMatrix certified_product(std::span<const AffineMatrix> matrices);
/// Of a matrix whose doubles are exact (tier A): decided exactly. `false` if the determinant is zero.
bool certified_inverse(const AffineMatrix& matrix, EnclosedMatrix& inverse);
/// The inverse transpose of the linear part.
bool certified_inverse_transpose(const AffineMatrix& matrix, EnclosedMatrix3& result);
/// Of the true product of steps (tier B).
bool certified_inverse(std::span<const TransformStep> steps, EnclosedMatrix& inverse);
/// The condition number |A| |A^-1| of the linear part in the largest-row-sum norm, to a relative 2^-40; infinity if
/// singular.
double condition_number(const AffineMatrix& matrix);

}  // namespace plumb
