#include "renderer/math/transform.h"

#include <cmath>

#include "renderer/math/rotation.h"

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

/// Adjugate over determinant, in the 64-bit significand of long double: the rounding of the products
/// then lies below that of the result unless the matrix is ill-conditioned past about 2^11.
AffineMatrix invert(const AffineMatrix& m) {
  if (!all_finite(m)) throw SingularTransform("the transform has an entry that is not finite");
  const auto e = [&](int r, int c) {
    return static_cast<long double>(m[static_cast<std::size_t>(r % 3)][static_cast<std::size_t>(c % 3)]);
  };
  // The cyclic indices give each cofactor its sign.
  const auto cofactor = [&](int r, int c) {
    return e(r + 1, c + 1) * e(r + 2, c + 2) - e(r + 1, c + 2) * e(r + 2, c + 1);
  };
  const long double det = e(0, 0) * cofactor(0, 0) + e(0, 1) * cofactor(0, 1) + e(0, 2) * cofactor(0, 2);
  if (det == 0) throw SingularTransform("the transform is singular: it flattens space, so it has no inverse");
  AffineMatrix inverse;
  for (std::size_t r = 0; r < 3; ++r) {
    long double offset = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const long double entry = cofactor(static_cast<int>(c), static_cast<int>(r)) / det;
      inverse[r][c] = static_cast<double>(entry);
      offset -= entry * static_cast<long double>(m[c][3]);
    }
    inverse[r][3] = static_cast<double>(offset);
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
  Bounds3 result;
  if (bounds.empty()) return result;
  for (int i = 0; i < 8; ++i) {
    const Point3 corner = apply(matrix_, bounds.corner(i));
    const Vec3 margin = rounding_bound(bounds.corner(i));
    result.extend(corner + margin);
    result.extend(corner + -1.0 * margin);
  }
  return result;
}

Vec3 Transform::rounding_bound(const Point3& p) const {
  if (is_identity_) return {};
  const auto row = [&](std::size_t i) {
    const auto& r = matrix_[i];
    return 8 * 0x1p-53 * (std::fabs(r[0] * p.x) + std::fabs(r[1] * p.y) + std::fabs(r[2] * p.z) + std::fabs(r[3]));
  };
  return {row(0), row(1), row(2)};
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

AffineMatrix rotation_degrees(const Vec3& angles) {
  const auto [cx, sx] = cos_sin_degrees(angles.x);
  const auto [cy, sy] = cos_sin_degrees(angles.y);
  const auto [cz, sz] = cos_sin_degrees(angles.z);
  const AffineMatrix about_x = {{{1, 0, 0, 0}, {0, cx, -sx, 0}, {0, sx, cx, 0}}};
  const AffineMatrix about_y = {{{cy, 0, sy, 0}, {0, 1, 0, 0}, {-sy, 0, cy, 0}}};
  const AffineMatrix about_z = {{{cz, -sz, 0, 0}, {sz, cz, 0, 0}, {0, 0, 1, 0}}};
  return about_z * (about_y * about_x);
}

}  // namespace plumb
