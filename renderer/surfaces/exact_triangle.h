#pragma once

#include <array>

#include "renderer/math/dyadic.h"
#include "renderer/math/ray.h"
#include "renderer/math/transform.h"

namespace plumb {

using TriangleVertices = std::array<Point3, 3>;

/// A ray and a triangle without rounding, in world space. With A, B, C the vertices as seen from the ray's origin and d
/// its direction:
///   u = d.(C x B), v = d.(A x C), w = d.(B x A), the weights of A, B, C times their sum;
///   t = A.(C x B) / (u + v + w).
/// A placed vertex is M p + T, exactly. Of degree 5 and 6 then, so that two t are compared in degree 11: within what a
/// Dyadic holds of any doubles.
class ExactTriangle {
 public:
  /// Which numbers: where all bits lie within few digits whole numbers of a fixed length, else Dyadic ones; or those
  /// always. Both give the same answers.
  enum class Numbers { shortest, dyadic };

  /// `world_from_object` is null for the identity. All numbers must be finite.
  ExactTriangle(const Ray& world, const Transform* world_from_object, const TriangleVertices& vertices,
                Numbers numbers = Numbers::shortest);

  /// Whether the ray's line meets it: on an edge or vertex too, from both sides; not in its plane, nor without area.
  bool is_met() const;
  // What follows is for what is met.

  /// -1, 0 or 1 where t lies below, at or above tau, which may be infinite.
  int compare_t(double tau) const;
  /// The same with another's t.
  int compare_t(const ExactTriangle& other) const;

  /// t and the weights of B and C, each rounded to nearest, ties to even; infinite beyond the largest double.
  double t() const;
  double weight_b() const;
  double weight_c() const;

 private:
  bool decide_by_integers(const Ray& world, const TriangleVertices& vertices);
  bool decide_by_integers(const Ray& world, const AffineMatrix& matrix, const TriangleVertices& vertices);
  template <class Weights>
  void take(const Weights& weights_and_numerator, int point_unit, int direction_unit);

  std::array<int, 3> signs_;
  /// t = numerator / sum, and the weights are parts of the sum. Of what is missed they may be zero.
  Dyadic v_, w_, sum_, numerator_;
};

}  // namespace plumb
