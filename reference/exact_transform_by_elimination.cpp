#include <CGAL/Mpzf.h>
#include <gmpxx.h>

#include <cmath>
#include <ranges>

#include "reference/exact_bounds_search.h"
#include "reference/exact_transform_affine.h"
#include "reference/exact_transform_cross_check.h"

namespace plumb {
namespace {

using Integer = CGAL::Mpzf;

template <class Number>
Affine<Number> exact(const AffineMatrix& matrix) {
  Affine<Number> result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 4; ++j) result[i][j] = Number(matrix[i][j]);
  return result;
}

/// The neighbours, found among all doubles by comparing alone.
template <class Number>
Enclosure enclose_by_search(const Number& x, double guess) {
  const double above = smallest_that_holds(guess, [&](double candidate) { return Number(candidate) >= x; });
  const double below = -smallest_that_holds(-guess, [&](double candidate) { return Number(-candidate) <= x; });
  return {below + 0.0, above + 0.0};
}

}  // namespace

EnclosedMatrix certified_product_by_expansions(std::span<const AffineMatrix> matrices) {
  Affine<Integer> result = exact<Integer>(identity_matrix());
  for (const AffineMatrix& matrix : std::views::reverse(matrices)) {
    if (!all_finite(matrix)) return unknown_matrix();
    result = product(exact<Integer>(matrix), result);
  }
  return enclose_entries(result, [](const Integer& x) { return enclose_by_search(x, x.to_double()); });
}

bool certified_inverse_by_elimination(const AffineMatrix& matrix, EnclosedMatrix& inverse) {
  inverse = unknown_matrix();
  if (!all_finite(matrix)) return false;
  // [A | I | b] becomes [I | A^-1 | A^-1 b].
  std::array<std::array<mpq_class, 7>, 3> rows;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) rows[i][j] = matrix[i][j];
    rows[i][3 + i] = 1;
    rows[i][6] = matrix[i][3];
  }
  for (std::size_t column = 0; column < 3; ++column) {
    std::size_t pivot = column;
    while (pivot < 3 && rows[pivot][column] == 0) ++pivot;
    if (pivot == 3) return false;
    std::swap(rows[pivot], rows[column]);
    const mpq_class scale = 1 / rows[column][column];
    for (mpq_class& entry : rows[column]) entry *= scale;
    for (std::size_t i = 0; i < 3; ++i) {
      if (i == column) continue;
      const mpq_class factor = rows[i][column];
      for (std::size_t j = 0; j < 7; ++j) rows[i][j] -= factor * rows[column][j];
    }
  }
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      const mpq_class entry = j < 3 ? rows[i][3 + j] : -rows[i][6];
      inverse[i][j] = enclose_by_search(entry, entry.get_d());
    }
  return true;
}

}  // namespace plumb
