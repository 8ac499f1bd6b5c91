#pragma once

#include <array>

#include "conformance/envelopes/textbook/arithmetic.h"
#include "renderer/math/rotation.h"

namespace plumb::textbook {

/// The upper three rows of an affine 4x4 matrix.
template <class A>
struct Matrix {
  using Real = RealOf<A>;
  using Row = std::array<Real, 4>;
  std::array<Row, 3> rows{Row{1, 0, 0, 0}, Row{0, 1, 0, 0}, Row{0, 0, 1, 0}};

  static Matrix translation(const Vector<A>& by) {
    Matrix m;
    for (std::size_t i = 0; i < 3; ++i) m.rows[i][3] = by[i];
    return m;
  }

  static Matrix scaling(const Vector<A>& factors) {
    Matrix m;
    for (std::size_t i = 0; i < 3; ++i) m.rows[i][i] = factors[i];
    return m;
  }

  /// About one axis, counter-clockwise seen from its tip. Cosine and sine are rounded from the correct ones, so that
  /// they are the same on every machine.
  static Matrix rotation(std::size_t axis, double degrees) {
    const CosSin turn = cos_sin_degrees(degrees);
    const std::size_t from = (axis + 1) % 3, to = (axis + 2) % 3;
    Matrix m;
    m.rows[from][from] = m.rows[to][to] = static_cast<Real>(turn.cos);
    m.rows[to][from] = static_cast<Real>(turn.sin);
    m.rows[from][to] = -static_cast<Real>(turn.sin);
    return m;
  }

  /// The linear part times the vector.
  Vector<A> turn(const Vector<A>& v) const {
    Vector<A> result;
    for (std::size_t i = 0; i < 3; ++i) result[i] = sum<A>(rows[i][0] * v.x, rows[i][1] * v.y, rows[i][2] * v.z);
    return result;
  }

  Vector<A> move(const Vector<A>& p) const { return turn(p) + Vector<A>{rows[0][3], rows[1][3], rows[2][3]}; }

  /// The transposed linear part times the vector: of an inverse, what carries normals.
  Vector<A> turn_transposed(const Vector<A>& v) const {
    Vector<A> result;
    for (std::size_t i = 0; i < 3; ++i) result[i] = sum<A>(rows[0][i] * v.x, rows[1][i] * v.y, rows[2][i] * v.z);
    return result;
  }

  friend Matrix operator*(const Matrix& a, const Matrix& b) {
    Matrix product;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 4; ++j)
        product.rows[i][j] =
            sum<A>(a.rows[i][0] * b.rows[0][j], a.rows[i][1] * b.rows[1][j], a.rows[i][2] * b.rows[2][j]);
      product.rows[i][3] += a.rows[i][3];
    }
    return product;
  }

  /// By cofactors. Not finite where there is none.
  Matrix inverse() const {
    Matrix result;
    const auto cofactor = [&](std::size_t i, std::size_t j) {
      const Row& p = rows[(i + 1) % 3];
      const Row& q = rows[(i + 2) % 3];
      return p[(j + 1) % 3] * q[(j + 2) % 3] - p[(j + 2) % 3] * q[(j + 1) % 3];
    };
    const Real determinant =
        sum<A>(rows[0][0] * cofactor(0, 0), rows[0][1] * cofactor(0, 1), rows[0][2] * cofactor(0, 2));
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) result.rows[i][j] = cofactor(j, i) / determinant;
    const Vector<A> back = result.turn({rows[0][3], rows[1][3], rows[2][3]});
    for (std::size_t i = 0; i < 3; ++i) result.rows[i][3] = -back[i];
    return result;
  }

  bool is_finite() const {
    for (const Row& row : rows)
      for (const Real entry : row)
        if (!std::isfinite(entry)) return false;
    return true;
  }
};

}  // namespace plumb::textbook
