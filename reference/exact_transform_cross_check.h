#pragma once

#include "reference/exact_transform.h"

namespace plumb {

/// Second ways to the answers of exact_transform.h, by other formulas (and number types where the first way is exact),
/// so that each can be held against the other. Those that take `bits` (at least 128) round at that precision only:
/// where it tells too little, an enclosure is wider than two neighbours, but it holds the true value; an interval that
/// is tiny (2^-200 of it, or narrower than the denormals) and holds one double stands for that double.

/// By reduction modulo a right angle, which is exact, and sines of radians. At 0, 30, 60 and 90 degrees the one
/// rational value is given, and no other multiple of a degree's fraction has one [Niven 1956, corollary 3.12].
EnclosedCosSin certified_cos_sin_by_radians(double degrees, int bits);
/// Rotations by quaternions of half angles (in radians), multiplied from the right.
EnclosedMatrix certified_product_by_quaternions(std::span<const TransformStep> steps, int bits);
/// By the adjugate over the determinant of that product; false if a factor is zero or a number not finite.
bool certified_inverse_by_quaternions(std::span<const TransformStep> steps, int bits, EnclosedMatrix& inverse);
/// In CGAL::Mpzf, multiplied from the right, the neighbours found by comparisons.
EnclosedMatrix certified_product_by_expansions(std::span<const AffineMatrix> matrices);
/// By Gauss-Jordan elimination of fractions.
bool certified_inverse_by_elimination(const AffineMatrix& matrix, EnclosedMatrix& inverse);

}  // namespace plumb
