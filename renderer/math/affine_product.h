#pragma once

#include "renderer/math/transform.h"

namespace plumb {

/// A product of affine maps, carried with twice the digits of a double and rounded once, at the end. In plain doubles
/// each factor of a deep nesting adds its rounding, and entries that cancel keep no digit.
class AffineProduct {
 public:
  /// The identity.
  AffineProduct();

  /// Each multiplies from the right, so that the last factor is applied to a point first.
  AffineProduct& translate(const Vec3& offset);
  AffineProduct& scale(const Vec3& factors);
  /// Rz Ry Rx: the rotation about x is applied first. In degrees; the cosines and sines have twice the digits too.
  AffineProduct& rotate_degrees(const Vec3& angles);

  /// Each entry rounded to the nearest double (in all but one of some thousand cases: within 0.51 of a unit of the last
  /// place). Not finite where an entry or a factor is not.
  AffineMatrix rounded() const;

 private:
  /// The sum of both, of which `low` is what is missing in `high`.
  struct Entry {
    double high = 0, low = 0;
  };
  using Entries = std::array<std::array<Entry, 4>, 3>;
  static Entry entry_of_product(const Entries& a, const Entries& b, std::size_t row, std::size_t column);
  static Entries entries_of(const AffineMatrix& matrix);
  AffineProduct& multiply_by(const Entries& factor);

  Entries entries_;
};

}  // namespace plumb
