#pragma once

#include <gmpxx.h>

#include <array>
#include <cstdint>
#include <vector>

#include "reference/algebraic_t.h"
#include "reference/shape.h"
#include "renderer/math/ray.h"

namespace plumb {

using RationalMatrix = std::array<std::array<mpq_class, 3>, 3>;
using RationalPoint = std::array<mpq_class, 3>;

/// Only guesses are made at this precision.
constexpr mp_bitcnt_t kApproximationBits = 512;

/// The inverse of the linear part, by elimination; false if it is singular.
bool invert(const AffineMatrix& matrix, RationalMatrix& inverse);

/// A double near `x`; the largest one beyond the range.
double double_near(const mpq_class& x);

/// A t on the line: a fraction, or one of the two roots of the side.
struct Event {
  /// -1 the fraction `value`, 0 the smaller root, 1 the larger.
  int root = -1;
  mpq_class value = 0;
};

/// An unnormalised outward normal in world space, at + t slope, multiplied out to whole numbers.
struct WholeNormal {
  std::array<mpz_class, 3> at, slope;
};

/// A ray's line in the solid's frame, in fractions. The side is a polynomial a t^2 + b t + c (found from its values at
/// -1, 0 and 1), negative inside; where it has two roots these are never computed: a fraction is held against them by
/// the sign of the polynomial there and the side of the vertex it lies on. Only for the .cpp files of this folder.
class RationalLine {
 public:
  RationalLine(const PlacedShape& placed, const RationalMatrix& inverse, const Ray& ray);

  /// Every t at which the line meets a limit, without repeats, by t.
  std::vector<Event> events() const;

  /// For each face, by part: 1 strictly inside of its limit, 0 on it, -1 outside.
  std::vector<int> faces_at(const Event& t) const;
  /// The same anywhere strictly between two neighbouring events.
  std::vector<int> faces_between(const Event& before, const Event& after) const;

  /// Whether the side has its double root there.
  bool double_root_at(const Event& t) const;

  /// The sign of t - x.
  int compare(const Event& t, const mpq_class& x) const;
  /// The sign of p0 + p1 t, and of p0 + p1 t + p2 t^2.
  int sign(const Event& t, const mpq_class& p0, const mpq_class& p1) const;
  int sign(const Event& t, const mpz_class& p0, const mpz_class& p1, const mpz_class& p2) const;

  mpf_class approximate(const Event& t) const;
  WholeNormal normal(const Event& t, std::uint32_t part) const;
  AlgebraicT algebraic(const Event& t) const;

 private:
  struct Slab {
    std::size_t axis;
    mpq_class low, high;
  };

  /// The side's form at a point of the object's space, negative inside.
  mpq_class side_at(const RationalPoint& p) const;
  RationalPoint point_at(const mpq_class& t) const;
  /// Half the gradient of side_at at the point, which is linear in it.
  RationalPoint gradient_at(const RationalPoint& p) const;
  RationalPoint to_world(const RationalPoint& normal) const;
  /// compare with x = numerator / denominator, in any terms; the denominator positive.
  int compare(const Event& t, const mpz_class& numerator, const mpz_class& denominator) const;
  /// Of the side's polynomial at such an x.
  int polynomial_sign(const mpz_class& numerator, const mpz_class& denominator) const;
  /// Fractions around t, at most 2^-bits of the scale of the roots apart.
  std::array<mpq_class, 2> around(const Event& t, unsigned bits) const;

  const PlacedShape& placed_;
  const RationalMatrix& inverse_;
  bool has_side_;
  std::vector<Slab> slabs_;
  RationalPoint origin_, direction_;
  /// Whole numbers, by a positive factor.
  mpz_class a_, b_, c_;
  /// With a not zero: the vertex, and the square of the roots' distance from it.
  mpq_class vertex_, distance_square_;
};

}  // namespace plumb
