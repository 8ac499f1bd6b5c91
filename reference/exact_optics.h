#pragma once

#include <optional>

#include "reference/exact_hit.h"
#include "renderer/math/vec3.h"

namespace plumb {

/// What light does at a smooth interface. All inputs are exact doubles: the cosine (in [0, 1]) between the normal and
/// the direction that it comes from, and the indices on either side (positive).
struct ExactFresnel {
  /// Decided exactly: sin^2 > (to / from)^2.
  bool total_internal_reflection = false;
  /// Exactly at the critical angle. Of doubles only a cosine of 0 between equal indices is: 1 - cosine^2 is otherwise
  /// no square of a fraction.
  bool critical = false;
  /// Distance from the critical angle, |(to/from)^2 - sin^2| relative to 1, for thresholds; infinity where to >= from.
  double distance_to_critical = 0;
  /// The share that is reflected, unpolarised [Shirley 13.1]; [1, 1] under total internal reflection, [0, 0] between
  /// equal indices.
  Enclosure reflectance;
  /// The cosine on the far side; 0 under total internal reflection.
  Enclosure refracted_cosine;
};
/// Throws std::invalid_argument outside of the domain. By fractions where the refracted cosine is one, else by MPFR at
/// 256 bits, doubled until the neighbours are decided.
ExactFresnel exact_fresnel(double cosine, double from, double to);
/// The same by other formulas (amplitudes from angles' sines and tangents instead of the cosines' quotients) and at
/// `bits` of precision (at least 256): where they tell too little, an enclosure is wider than neighbours, but holds the
/// true value; an interval that is tiny (2^-200 of it) and holds one double is taken for that double.
ExactFresnel exact_fresnel_by_angles(double cosine, double from, double to, int bits);

/// The refracted direction of a unit-length incoming `direction` (towards the surface) at unit `normal` (both taken
/// exactly, and normalised exactly first), each coordinate rounded to nearest; nothing under total internal reflection.
/// Throws std::invalid_argument for a zero or non-finite vector, a direction away from the surface (along it is fine)
/// or an index that is not positive and finite.
std::optional<Vec3> exact_refracted(const Vec3& direction, const Vec3& normal, double from, double to);

}  // namespace plumb
