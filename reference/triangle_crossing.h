#pragma once

#include <array>
#include <optional>

#include "reference/quotient.h"
#include "reference/triangle_oracle.h"
#include "renderer/math/ray.h"
#include "renderer/math/transform.h"

namespace plumb {

/// Whether a ray is in the oracle's domain: finite but for the ends of its range, the direction not zero, t_min <=
/// t_max.
bool is_valid(const Ray& ray);

/// Where a ray meets a triangle within its range, in exact numbers. For the oracle's own sources only.
struct TriangleCrossing {
  Quotient t, u, v;
  /// On an edge or a vertex.
  bool boundary = false;
  RangePlace place = RangePlace::within;
  /// In world space; the normal by the triangle's winding, of any length.
  std::array<Quotient, 3> position;
  std::array<mpz_class, 3> normal;
};

/// Rays against triangles under an affine map by signs of polynomials, with no division: the vertices are taken to
/// world space. Numbers are CGAL::Mpzf, which has no limit to its exponents. All inputs must be finite, the direction
/// not zero, t_min <= t_max.
class PolynomialTriangles {
 public:
  PolynomialTriangles(const AffineMatrix& world_from_object, const Ray& ray);
  /// The determinant of the matrix is zero: then crossing() must not be called.
  bool singular() const { return determinant_sign_ == 0; }
  std::optional<TriangleCrossing> crossing(const Point3& a, const Point3& b, const Point3& c) const;

 private:
  AffineMatrix matrix_;
  bool identity_;
  int determinant_sign_;
  Ray ray_;
};

/// The same by fractions and other formulas: the ray is taken to object space by the inverse matrix and cut with the
/// triangle's plane; the point's barycentrics are solved for in a projection along an axis.
class RationalTriangles {
 public:
  RationalTriangles(const AffineMatrix& world_from_object, const Ray& ray);
  bool singular() const { return singular_; }
  std::optional<TriangleCrossing> crossing(const Point3& a, const Point3& b, const Point3& c) const;

 private:
  using Vector = std::array<mpq_class, 3>;

  bool singular_ = false;
  std::array<std::array<mpq_class, 4>, 3> matrix_;
  std::array<Vector, 3> inverse_;
  Vector origin_, direction_;
  Ray ray_;
};

/// The last stage of decide_triangle_exactly(); all numbers must be finite.
TriangleDecision decide_triangle_by_numbers(const Ray& ray, const Point3& a, const Point3& b, const Point3& c);

}  // namespace plumb
