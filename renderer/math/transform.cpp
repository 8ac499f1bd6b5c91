#include "renderer/math/transform.h"

#include <algorithm>
#include <cmath>

#include "renderer/math/affine_product.h"
#include "renderer/math/exact_sum.h"
#include "renderer/math/support.h"

namespace plumb {
namespace {

Point3 apply(const AffineMatrix& m, const Point3& p) {
  const auto row = [&](int i) {
    const auto& r = m[static_cast<std::size_t>(i)];
    return r[0] * p.x + r[1] * p.y + r[2] * p.z + r[3];
  };
  return {row(0), row(1), row(2)};
}

Vec3 apply(const AffineMatrix& m, const Vec3& v) {
  const auto row = [&](int i) {
    const auto& r = m[static_cast<std::size_t>(i)];
    return r[0] * v.x + r[1] * v.y + r[2] * v.z;
  };
  return {row(0), row(1), row(2)};
}

bool all_finite(const AffineMatrix& m) {
  for (const auto& row : m)
    for (const double entry : row)
      if (!std::isfinite(entry)) return false;
  return true;
}

/// The matrix with its rows and first three columns multiplied by powers of two, so that the largest number of each is
/// near 1. Then no product in the inverse leaves the range of doubles. What was taken out, as exponents of two, is in
/// `row` and `column`.
struct Levelled {
  AffineMatrix entries;
  std::array<int, 3> row, column;
};

/// 0 for zero.
int exponent(double x) { return x == 0 ? 0 : std::ilogb(x); }

Levelled levelled(const AffineMatrix& m) {
  Levelled result{m, {}, {}};
  auto& [entries, row, column] = result;
  for (std::size_t c = 0; c < 3; ++c) {
    column[c] = exponent(std::max({std::fabs(m[0][c]), std::fabs(m[1][c]), std::fabs(m[2][c])}));
    for (std::size_t r = 0; r < 3; ++r) entries[r][c] = std::ldexp(m[r][c], -column[c]);
  }
  for (std::size_t r = 0; r < 3; ++r) {
    auto& e = entries[r];
    row[r] = exponent(std::max({std::fabs(e[0]), std::fabs(e[1]), std::fabs(e[2])}));
    for (std::size_t c = 0; c < 3; ++c) e[c] = std::ldexp(e[c], -row[r]);
  }
  return result;
}

/// Adjugate over determinant. Both are exact, so each entry of the inverse has three roundings to 64 bits and one to a
/// double: it is within 0.51 of a unit of its last place, whatever the condition.
AffineMatrix invert(const AffineMatrix& m) {
  if (!all_finite(m)) throw SingularTransform("the transform has an entry that is not finite");
  const Levelled level = levelled(m);
  const auto e = [&](std::size_t r, std::size_t c) { return level.entries[r % 3][c % 3]; };
  // The cyclic indices give each cofactor its sign.
  const auto cofactor = [&](std::size_t r, std::size_t c) {
    return ExactSum().add_product(e(r + 1, c + 1), e(r + 2, c + 2)).add_product(-e(r + 1, c + 2), e(r + 2, c + 1));
  };
  const ExactSum exact_det = e(0, 0) * cofactor(0, 0) + e(0, 1) * cofactor(0, 1) + e(0, 2) * cofactor(0, 2);
  if (exact_det.sign() == 0)
    throw SingularTransform("the transform is singular: it flattens space, so it has no inverse");
  const long double det = exact_det.rounded();
  const auto quotient = [&](const ExactSum& numerator, int exponent_taken_out) {
    // The sum with zero takes the sign off a zero.
    return static_cast<double>(std::ldexp(numerator.rounded() / det, -exponent_taken_out) + 0.0L);
  };
  AffineMatrix inverse;
  for (std::size_t r = 0; r < 3; ++r) {
    const std::array<ExactSum, 3> adjugate{cofactor(0, r), cofactor(1, r), cofactor(2, r)};
    int largest = -3000;  // the exponent of the largest offset that counts in this row, levelled
    for (std::size_t c = 0; c < 3; ++c) {
      inverse[r][c] = quotient(adjugate[c], level.column[r] + level.row[c]);
      if (adjugate[c].sign() != 0 && m[c][3] != 0) largest = std::max(largest, exponent(m[c][3]) - level.row[c]);
    }
    ExactSum offset;
    for (std::size_t c = 0; c < 3; ++c)
      if (adjugate[c].sign() != 0) offset -= adjugate[c] * std::ldexp(m[c][3], -level.row[c] - largest);
    inverse[r][3] = quotient(offset, level.column[r] - largest);
  }
  if (!all_finite(inverse)) throw SingularTransform("the transform is singular within the range of doubles");
  return inverse;
}

}  // namespace

AffineMatrix operator*(const AffineMatrix& a, const AffineMatrix& b) {
  AffineMatrix product;
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 4; ++c) {
      product[r][c] = a[r][0] * b[0][c] + a[r][1] * b[1][c] + a[r][2] * b[2][c];
      if (c == 3) product[r][c] += a[r][3];
    }
  }
  return product;
}

Transform::Transform() : matrix_(identity_matrix()), inverse_(identity_matrix()), is_identity_(true) {}

Transform::Transform(const AffineMatrix& matrix)
    : matrix_(matrix), inverse_(invert(matrix)), is_identity_(matrix == identity_matrix()) {}

Transform Transform::inverse() const {
  Transform result = *this;
  std::swap(result.matrix_, result.inverse_);
  return result;
}

Point3 Transform::operator()(const Point3& p) const { return apply(matrix_, p); }
Vec3 Transform::operator()(const Vec3& v) const { return apply(matrix_, v); }

Normal3 Transform::operator()(const Normal3& n) const {
  const auto column = [&](std::size_t i) { return inverse_[0][i] * n.x + inverse_[1][i] * n.y + inverse_[2][i] * n.z; };
  return {column(0), column(1), column(2)};
}

Ray Transform::operator()(const Ray& ray) const {
  return {apply(matrix_, ray.origin), apply(matrix_, ray.direction), ray.t_min, ray.t_max};
}

Bounds3 Transform::operator()(const Bounds3& bounds) const {
  if (bounds.empty()) return {};
  return mapped_bounds(matrix_, [&](const AffineRow& row) { return highest(row, bounds); });
}

Ray Transform::inverse_of(const Ray& ray) const {
  return {apply(inverse_, ray.origin), apply(inverse_, ray.direction), ray.t_min, ray.t_max};
}

AffineMatrix identity_matrix() { return scaling({1, 1, 1}); }

AffineMatrix translation(const Vec3& offset) {
  return {{{1, 0, 0, offset.x}, {0, 1, 0, offset.y}, {0, 0, 1, offset.z}}};
}

AffineMatrix scaling(const Vec3& factors) {
  return {{{factors.x, 0, 0, 0}, {0, factors.y, 0, 0}, {0, 0, factors.z, 0}}};
}

AffineMatrix rotation_degrees(const Vec3& angles) { return AffineProduct().rotate_degrees(angles).rounded(); }

}  // namespace plumb
