#include <cmath>

#include "reference/triangle_crossing.h"

namespace plumb {
namespace {

using Vector = std::array<mpq_class, 3>;

template <class Triple>
Vector vector(const Triple& v) {
  return {mpq_class(v.x), mpq_class(v.y), mpq_class(v.z)};
}

Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

mpq_class scalar(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// The minor of a 3x3 matrix without row i and column j, with its sign.
template <class Matrix>
mpq_class cofactor(const Matrix& m, std::size_t i, std::size_t j) {
  const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
  return m[i1][j1] * m[i2][j2] - m[i1][j2] * m[i2][j1];
}

/// Whole numbers in the same proportions, the sign kept.
std::array<mpz_class, 3> whole(const Vector& v) {
  const mpz_class denominator = lcm(lcm(v[0].get_den(), v[1].get_den()), v[2].get_den());
  std::array<mpz_class, 3> result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = v[i].get_num() * (denominator / v[i].get_den());
  return result;
}

std::optional<RangePlace> place_in_range(const mpq_class& t, double t_min, double t_max) {
  const auto order = [&](double tau) { return std::isinf(tau) ? (tau < 0 ? 1 : -1) : cmp(t, mpq_class(tau)); };
  const int above_min = order(t_min), above_max = order(t_max);
  if (above_min < 0 || above_max > 0) return std::nullopt;
  if (above_min == 0) return RangePlace::at_min;
  return above_max == 0 ? RangePlace::at_max : RangePlace::within;
}

}  // namespace

RationalTriangles::RationalTriangles(const AffineMatrix& world_from_object, const Ray& ray) : ray_(ray) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 4; ++j) matrix_[i][j] = world_from_object[i][j];
  mpq_class determinant = 0;
  for (std::size_t j = 0; j < 3; ++j) determinant += matrix_[0][j] * cofactor(matrix_, 0, j);
  singular_ = determinant == 0;
  if (singular_) return;
  const Vector translation{matrix_[0][3], matrix_[1][3], matrix_[2][3]};
  const Vector shifted = minus(vector(ray.origin), translation), direction = vector(ray.direction);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) inverse_[i][j] = cofactor(matrix_, j, i) / determinant;
    origin_[i] = scalar(inverse_[i], shifted);
    direction_[i] = scalar(inverse_[i], direction);
  }
}

std::optional<TriangleCrossing> RationalTriangles::crossing(const Point3& a, const Point3& b, const Point3& c) const {
  const Vector corner = vector(a), first = minus(vector(b), corner), second = minus(vector(c), corner);
  Vector normal;
  for (std::size_t i = 0; i < 3; ++i)
    normal[i] = first[(i + 1) % 3] * second[(i + 2) % 3] - first[(i + 2) % 3] * second[(i + 1) % 3];
  const mpq_class slope = scalar(normal, direction_);
  if (slope == 0) return std::nullopt;  // coplanar, parallel, or a triangle without area
  const mpq_class t = scalar(normal, minus(corner, origin_)) / slope;
  const std::optional<RangePlace> place = place_in_range(t, ray_.t_min, ray_.t_max);
  if (!place) return std::nullopt;

  Vector point;
  for (std::size_t i = 0; i < 3; ++i) point[i] = origin_[i] + t * direction_[i];
  // Seen along an axis on which the normal is not zero, the triangle keeps an area.
  const std::size_t axis = normal[0] != 0 ? 0 : normal[1] != 0 ? 1 : 2;
  const std::size_t x = (axis + 1) % 3, y = (axis + 2) % 3;
  const Vector inside = minus(point, corner);
  const mpq_class u = (inside[x] * second[y] - inside[y] * second[x]) / normal[axis];
  const mpq_class v = (first[x] * inside[y] - first[y] * inside[x]) / normal[axis];
  const mpq_class rest = 1 - u - v;
  if (u < 0 || v < 0 || rest < 0) return std::nullopt;

  TriangleCrossing result;
  result.t = make_quotient(t);
  result.u = make_quotient(u);
  result.v = make_quotient(v);
  result.boundary = u == 0 || v == 0 || rest == 0;
  result.place = *place;
  Vector turned;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector row{matrix_[i][0], matrix_[i][1], matrix_[i][2]};
    result.position[i] = make_quotient(scalar(row, point) + matrix_[i][3]);
    turned[i] = inverse_[0][i] * normal[0] + inverse_[1][i] * normal[1] + inverse_[2][i] * normal[2];
  }
  result.normal = whole(turned);
  return result;
}

}  // namespace plumb
