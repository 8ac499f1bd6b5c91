#include <gmpxx.h>

#include <algorithm>
#include <cmath>

#include "reference/exact_transform.h"
#include "reference/exact_transform_affine.h"
#include "reference/mpfr_interval.h"

namespace plumb {
namespace {

using Rational = mpq_class;

Affine<Rational> rational(const AffineMatrix& matrix) {
  Affine<Rational> result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 4; ++j) result[i][j] = matrix[i][j];
  return result;
}

/// By the adjugate over the determinant; false if that is zero.
bool invert(const Affine<Rational>& a, Affine<Rational>& inverse) {
  const auto adjugate_of_a = adjugate(a);
  Rational determinant = 0;
  for (std::size_t k = 0; k < 3; ++k) determinant += a[0][k] * adjugate_of_a[k][0];
  if (determinant == 0) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    inverse[i][3] = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      inverse[i][j] = adjugate_of_a[i][j] / determinant;
      inverse[i][3] -= inverse[i][j] * a[j][3];
    }
  }
  return true;
}

/// The largest sum of magnitudes in a row of the linear part.
Rational row_sum_norm(const Affine<Rational>& a) {
  Rational largest = 0;
  for (const auto& row : a) largest = std::max(largest, Rational(abs(row[0]) + abs(row[1]) + abs(row[2])));
  return largest;
}

}  // namespace

EnclosedMatrix certified_product(std::span<const AffineMatrix> matrices) {
  Affine<Rational> result = rational(identity_matrix());
  for (const AffineMatrix& matrix : matrices) {
    if (!all_finite(matrix)) return unknown_matrix();
    result = product(result, rational(matrix));
  }
  return enclose_entries(result, enclose);
}

bool certified_inverse(const AffineMatrix& matrix, EnclosedMatrix& inverse) {
  inverse = unknown_matrix();
  Affine<Rational> exact;
  if (!all_finite(matrix) || !invert(rational(matrix), exact)) return false;
  inverse = enclose_entries(exact, enclose);
  return true;
}

bool certified_inverse_transpose(const AffineMatrix& matrix, EnclosedMatrix3& result) {
  EnclosedMatrix inverse;
  const bool regular = certified_inverse(matrix, inverse);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) result[i][j] = inverse[j][i];
  return regular;
}

double condition_number(const AffineMatrix& matrix) {
  if (!all_finite(matrix)) return std::numeric_limits<double>::quiet_NaN();
  const Affine<Rational> exact = rational(matrix);
  Affine<Rational> inverse;
  if (!invert(exact, inverse)) return std::numeric_limits<double>::infinity();
  return nearest(row_sum_norm(exact) * row_sum_norm(inverse));
}

}  // namespace plumb
