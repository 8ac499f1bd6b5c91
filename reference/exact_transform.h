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

/// The cosine and sine of an angle in degrees, exactly enclosed: equal bounds where they are 0, +-1/2 or +-1. NaN for
/// an angle that is not finite.
struct EnclosedCosSin {
  Enclosure cos, sin;
};
EnclosedCosSin certified_cos_sin(double degrees);

/// The product of the steps in file order (the first is outermost), true values: fractions where every rotation is by
/// multiples of 90 degrees; else MPFR intervals, the precision doubled from 256 to 2048 bits until each entry's
/// neighbours are decided. An entry that 2048 bits cannot tell from a double (two turns by 45 degrees; the cosine of
/// 1e-320 degrees) is given as that double. All NaN if a number is not finite.
EnclosedMatrix certified_product(std::span<const TransformStep> steps);
/// The product of matrices whose doubles are exact, left to right; each entry enclosed. All NaN if a number is not
/// finite.
EnclosedMatrix certified_product(std::span<const AffineMatrix> matrices);
/// Of a matrix whose doubles are exact (tier A): decided exactly. `false` (and all NaN) if the determinant is zero
/// or a number is not finite.
bool certified_inverse(const AffineMatrix& matrix, EnclosedMatrix& inverse);
/// The inverse transpose of the linear part; likewise.
bool certified_inverse_transpose(const AffineMatrix& matrix, EnclosedMatrix3& result);
/// Of the true product of steps (tier B); `false` if a factor of a scaling is zero or a number is not finite.
bool certified_inverse(std::span<const TransformStep> steps, EnclosedMatrix& inverse);
/// The condition number |A| |A^-1| of the linear part in the largest-row-sum norm, rounded to nearest from the exact
/// value; infinity if singular, NaN if a number is not finite.
double condition_number(const AffineMatrix& matrix);

}  // namespace plumb
