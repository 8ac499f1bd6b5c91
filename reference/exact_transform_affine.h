#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "reference/exact_transform.h"

namespace plumb {

/// An affine matrix of exact numbers or intervals; a default-constructed Number is zero.
template <class Number>
using Affine = std::array<std::array<Number, 4>, 3>;

template <class Number>
Affine<Number> product(const Affine<Number>& a, const Affine<Number>& b) {
  Affine<Number> result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      Number sum = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
      if (j == 3) sum = sum + a[i][3];
      result[i][j] = std::move(sum);
    }
  return result;
}

template <class Number>
void transpose_linear_part(Affine<Number>& a) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < i; ++j) std::swap(a[i][j], a[j][i]);
}

/// The inverse of a linear part times its determinant.
template <class Number>
std::array<std::array<Number, 3>, 3> adjugate(const Affine<Number>& a) {
  std::array<std::array<Number, 3>, 3> result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      // Indices that go round make the signs right.
      const std::size_t r1 = (j + 1) % 3, r2 = (j + 2) % 3, c1 = (i + 1) % 3, c2 = (i + 2) % 3;
      result[i][j] = a[r1][c1] * a[r2][c2] - a[r1][c2] * a[r2][c1];
    }
  return result;
}

inline constexpr Enclosure kUnknown{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};

inline EnclosedMatrix unknown_matrix() {
  EnclosedMatrix result;
  for (auto& row : result) row.fill(kUnknown);
  return result;
}

template <class Number, class Enclose>
EnclosedMatrix enclose_entries(const Affine<Number>& a, const Enclose& enclose_entry) {
  EnclosedMatrix result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 4; ++j) result[i][j] = enclose_entry(a[i][j]);
  return result;
}

inline bool all_finite(std::span<const TransformStep> steps) {
  for (const TransformStep& step : steps)
    if (!is_finite(step.value)) return false;
  return true;
}

inline bool all_finite(const AffineMatrix& matrix) {
  for (const auto& row : matrix)
    for (const double entry : row)
      if (!std::isfinite(entry)) return false;
  return true;
}

/// Whether the product of the steps has no inverse: a factor of zero.
inline bool flattens(std::span<const TransformStep> steps) {
  for (const TransformStep& step : steps)
    if (step.kind == TransformStep::Kind::scale && (step.value.x == 0 || step.value.y == 0 || step.value.z == 0))
      return true;
  return false;
}

/// The matrix of one step. `Numbers` makes a Number of a double and the rotation about x, y and z by degrees.
template <class Numbers>
auto step_matrix(const Numbers& numbers, const TransformStep& step) {
  using Number = typename Numbers::Number;
  Affine<Number> result;
  if (step.kind == TransformStep::Kind::rotate) return numbers.rotation(step.value);
  const bool scales = step.kind == TransformStep::Kind::scale;
  for (std::size_t i = 0; i < 3; ++i) {
    const double value = step.value[static_cast<int>(i)];
    result[i][i] = numbers.of(scales ? value : 1);
    result[i][3] = numbers.of(scales ? 0 : value);
  }
  return result;
}

/// The rotation about one axis by the angle of this cosine and sine.
template <class Number>
Affine<Number> axis_rotation(std::size_t axis, const Number& one, const Number& cos, const Number& sin) {
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  Affine<Number> result;
  result[axis][axis] = one;
  result[u][u] = result[v][v] = cos;
  result[u][v] = -sin;
  result[v][u] = sin;
  return result;
}

}  // namespace plumb
