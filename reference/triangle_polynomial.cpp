#include <CGAL/Mpzf.h>

#include <algorithm>
#include <cmath>

#include "reference/triangle_crossing.h"

namespace plumb {
namespace {

using Number = CGAL::Mpzf;
using Vector = std::array<Number, 3>;

int sign(const Number& x) { return static_cast<int>(x.sign()); }

Number dot_product(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector cross_product(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

template <class Triple>
Vector vector(const Triple& v) {
  return {Number(v.x), Number(v.y), Number(v.z)};
}

Quotient quotient(const Number& numerator, const Number& denominator) {
  return make_quotient(static_cast<mpq_class>(numerator), static_cast<mpq_class>(denominator));
}

/// Whole numbers in the same proportions.
std::array<mpz_class, 3> whole(const Vector& v) {
  // The denominators are powers of two: the largest serves all.
  std::array<mpq_class, 3> exact;
  mpz_class denominator = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    exact[i] = static_cast<mpq_class>(v[i]);
    denominator = std::max(denominator, exact[i].get_den());
  }
  std::array<mpz_class, 3> result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = exact[i].get_num() * (denominator / exact[i].get_den());
  return result;
}

Vector column(const AffineMatrix& m, std::size_t j) { return {Number(m[0][j]), Number(m[1][j]), Number(m[2][j])}; }

/// The place of t = T / D in the range; nothing outside of it.
std::optional<RangePlace> place_in_range(const Number& t, const Number& d, double t_min, double t_max) {
  const int d_sign = sign(d);
  const auto side_of = [&](double tau) {
    return std::isinf(tau) ? (tau < 0 ? 1 : -1) : sign(t - Number(tau) * d) * d_sign;
  };
  const int above_min = side_of(t_min);
  if (above_min < 0) return std::nullopt;
  const int above_max = side_of(t_max);
  if (above_max > 0) return std::nullopt;
  return above_min == 0 ? RangePlace::at_min : above_max == 0 ? RangePlace::at_max : RangePlace::within;
}

/// U, V and W, the weights of the vertices as seen from the ray's origin.
struct Weights {
  Weights(const Vector& a, const Vector& b, const Vector& c, const Vector& d) {
    const Vector turned = cross_product(b, d);
    u = dot_product(c, turned);
    w = Number(0) - dot_product(a, turned);
    v = dot_product(d, cross_product(a, c));
  }
  bool mixed() const {
    const int low = std::min({sign(u), sign(v), sign(w)});
    const int high = std::max({sign(u), sign(v), sign(w)});
    return low < 0 && high > 0;
  }
  bool boundary() const { return sign(u) == 0 || sign(v) == 0 || sign(w) == 0; }

  Number u, v, w;
};

Sign to_sign(const Number& x) { return static_cast<Sign>(sign(x)); }

}  // namespace

PolynomialTriangles::PolynomialTriangles(const AffineMatrix& world_from_object, const Ray& ray)
    : matrix_(world_from_object), identity_(matrix_ == identity_matrix()), determinant_sign_(1), ray_(ray) {
  if (!identity_)
    determinant_sign_ = sign(dot_product(column(matrix_, 0), cross_product(column(matrix_, 1), column(matrix_, 2))));
}

std::optional<TriangleCrossing> PolynomialTriangles::crossing(const Point3& a, const Point3& b, const Point3& c) const {
  const Vector origin = vector(ray_.origin), direction = vector(ray_.direction);
  const auto seen = [&](const Point3& p) {
    Vector world = vector(p);
    if (!identity_)
      for (std::size_t i = 0; i < 3; ++i)
        world[i] = Number(matrix_[i][0]) * Number(p.x) + Number(matrix_[i][1]) * Number(p.y) +
                   Number(matrix_[i][2]) * Number(p.z) + Number(matrix_[i][3]);
    return world - origin;
  };
  const Vector seen_a = seen(a), seen_b = seen(b), seen_c = seen(c);
  const Weights weights(seen_a, seen_b, seen_c, direction);
  if (weights.mixed()) return std::nullopt;
  const Number d = weights.u + weights.v + weights.w;
  if (sign(d) == 0) return std::nullopt;
  const Number t = dot_product(seen_a, cross_product(seen_c, seen_b));
  const std::optional<RangePlace> place = place_in_range(t, d, ray_.t_min, ray_.t_max);
  if (!place) return std::nullopt;

  TriangleCrossing result;
  result.t = quotient(t, d);
  result.u = quotient(weights.v, d);
  result.v = quotient(weights.w, d);
  result.boundary = weights.boundary();
  result.place = *place;
  for (std::size_t i = 0; i < 3; ++i) result.position[i] = quotient(origin[i] * d + t * direction[i], d);
  // M^-T n = cof(M) n / det(M), and cof(M) (e1 x e2) = (M e1) x (M e2): a mirrored matrix turns the world's winding.
  const Vector normal = cross_product(seen_b - seen_a, seen_c - seen_a);
  result.normal = whole(determinant_sign_ > 0 ? normal : Vector() - normal);
  return result;
}

TriangleDecision decide_triangle_by_numbers(const Ray& ray, const Point3& a, const Point3& b, const Point3& c) {
  const Vector origin = vector(ray.origin);
  const Vector seen_a = vector(a) - origin, seen_b = vector(b) - origin, seen_c = vector(c) - origin;
  const Weights weights(seen_a, seen_b, seen_c, vector(ray.direction));
  TriangleDecision decision{HitClass::miss, DecidedBy::rational};
  decision.u = to_sign(weights.u);
  decision.v = to_sign(weights.v);
  decision.w = to_sign(weights.w);
  if (weights.mixed()) return decision;
  const Number d = weights.u + weights.v + weights.w;
  const Number t = dot_product(seen_a, cross_product(seen_c, seen_b));
  decision.d = to_sign(d);
  decision.t = to_sign(t);
  if (sign(d) != 0 && place_in_range(t, d, ray.t_min, ray.t_max))
    decision.hit_class = weights.boundary() ? HitClass::boundary : HitClass::hit;
  return decision;
}

double edge_margin(const Ray& ray, const Point3& a, const Point3& b, const Point3& c, double unit) {
  if (!is_finite(ray.origin) || !is_finite(ray.direction) || !is_finite(a) || !is_finite(b) || !is_finite(c))
    return std::numeric_limits<double>::quiet_NaN();
  const auto size = [](const Number& x) { return sign(x) < 0 ? Number(0) - x : x; };
  const auto longest = [&](const Vector& v) { return std::max({size(v[0]), size(v[1]), size(v[2])}); };
  const Vector origin = vector(ray.origin), d = vector(ray.direction);
  const Vector seen_a = vector(a) - origin, seen_b = vector(b) - origin, seen_c = vector(c) - origin;
  const Number seen = std::max({longest(seen_a), longest(seen_b), longest(seen_c)});
  const Number edge = std::max({longest(seen_b - seen_a), longest(seen_c - seen_b), longest(seen_a - seen_c)});
  const Number scale = (size(d[0]) + size(d[1]) + size(d[2])) * seen * edge * Number(unit);
  if (sign(scale) == 0) return 0;
  const Weights weights(seen_a, seen_b, seen_c, d);
  return round_quotient(quotient(std::min({size(weights.u), size(weights.v), size(weights.w)}), scale)).to_double;
}

}  // namespace plumb
