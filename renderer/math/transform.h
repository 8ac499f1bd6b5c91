#pragma once

#include <array>
#include <stdexcept>

#include "renderer/math/bounds3.h"
#include "renderer/math/ray.h"
#include "renderer/math/vec3.h"

namespace plumb {

/// Thrown where an affine matrix has no inverse.
class SingularTransform : public std::domain_error {
 public:
  using std::domain_error::domain_error;
};

/// The upper three rows of a 4x4 affine matrix; the fourth is 0 0 0 1.
using AffineMatrix = std::array<std::array<double, 4>, 3>;

/// The product, with the terms of each entry added from left to right.
AffineMatrix operator*(const AffineMatrix& a, const AffineMatrix& b);

/// An affine map and its inverse. Variables are named `to_from`: `world_from_object` takes object space
/// to world space. The inverse is that of the matrix that is stored, whatever product made it,
/// each entry within 0.51 of a unit of its last place.
class Transform {
 public:
  /// The identity.
  Transform();
  /// Throws SingularTransform if the determinant is zero, or an entry of the matrix or of its inverse is
  /// not finite.
  explicit Transform(const AffineMatrix& matrix);

  const AffineMatrix& matrix() const { return matrix_; }
  const AffineMatrix& inverse_matrix() const { return inverse_; }
  /// The map in the other direction.
  Transform inverse() const;
  bool is_identity() const { return is_identity_; }

  Point3 operator()(const Point3& p) const;
  Vec3 operator()(const Vec3& v) const;
  /// Multiplies by the inverse transpose; the length of the result is not 1.
  Normal3 operator()(const Normal3& n) const;
  /// Maps origin and direction. The direction is not renormalised, so t means the same in both frames.
  Ray operator()(const Ray& ray) const;
  /// The smallest box, in doubles, that holds every mapped point of the box. Empty for an empty box.
  Bounds3 operator()(const Bounds3& bounds) const;

  /// The ray in the frame that this transform maps from.
  Ray inverse_of(const Ray& ray) const;

 private:
  AffineMatrix matrix_;
  AffineMatrix inverse_;
  bool is_identity_;
};

AffineMatrix identity_matrix();
AffineMatrix translation(const Vec3& offset);
AffineMatrix scaling(const Vec3& factors);
/// Rz Ry Rx: the rotation about x is applied first. Angles in degrees; entries as by AffineProduct.
AffineMatrix rotation_degrees(const Vec3& angles);

}  // namespace plumb
