#include <CGAL/Mpzf.h>

#include <array>
#include <limits>

#include "reference/exact_optics.h"
#include "reference/exact_optics_cross_check.h"
#include "reference/exact_optics_domain.h"
#include "reference/mpfr_interval.h"

namespace plumb {
namespace {

using Integer = CGAL::Mpzf;

constexpr int kLastBits = 4096;

/// The sign of to^2 - from^2 sin^2, without a division: negative under total reflection.
int side_of_critical(double cosine, double from, double to) {
  const Integer f(from), t(to), fc = f * Integer(cosine);
  const Integer difference = fc * fc - (f - t) * (f + t);
  return difference < 0 ? -1 : difference > 0 ? 1 : 0;
}

/// Whether `a` may be as large as `b`.
bool may_reach(const MpfrInterval& a, const MpfrInterval& b) { return !mpfr_less_p(a.upper().get(), b.lower().get()); }

/// Of angles between 0 and pi, where the sine first rises, then falls.
MpfrInterval sine_of_sum(const MpfrInterval& sum, const MpfrInterval& right_angle) {
  MpfrNumber at_lower(sum.bits()), at_upper(sum.bits()), lower(sum.bits()), upper(sum.bits());
  mpfr_sin(at_lower.get(), sum.lower().get(), MPFR_RNDD);
  mpfr_sin(at_upper.get(), sum.upper().get(), MPFR_RNDD);
  mpfr_min(lower.get(), at_lower.get(), at_upper.get(), MPFR_RNDD);
  mpfr_sin(at_lower.get(), sum.lower().get(), MPFR_RNDU);
  mpfr_sin(at_upper.get(), sum.upper().get(), MPFR_RNDU);
  mpfr_max(upper.get(), at_lower.get(), at_upper.get(), MPFR_RNDU);
  const bool holds_top = mpfr_lessequal_p(sum.lower().get(), right_angle.upper().get()) &&
                         mpfr_greaterequal_p(sum.upper().get(), right_angle.lower().get());
  if (holds_top) mpfr_set_ui(upper.get(), 1, MPFR_RNDU);
  return {std::move(lower), std::move(upper)};
}

/// Fresnel's equations in the sine and tangent of sum and difference of the angles of incidence and refraction. The
/// tangent of the sum has a pole at Brewster's angle; its reciprocal has none.
MpfrInterval reflectance_by_angles(const MpfrInterval& incident, const MpfrInterval& refracted, int bits) {
  const MpfrInterval right_angle = MpfrInterval::pi(bits) * MpfrInterval(0.5, bits);
  const MpfrInterval sum = incident + refracted, difference = incident - refracted;
  if (may_reach(sum, MpfrInterval::pi(bits)) || may_reach(difference, right_angle) ||
      may_reach(-difference, right_angle))
    return {MpfrNumber(bits), MpfrInterval(1, bits).upper()};  // too few bits to tell anything
  const MpfrInterval perpendicular = increasing(mpfr_sin, difference) / sine_of_sum(sum, right_angle);
  const MpfrInterval parallel = increasing(mpfr_tan, difference) * decreasing(mpfr_cot, sum);
  return at_most(MpfrInterval(0.5, bits) * (square(perpendicular) + square(parallel)), 1);
}

double distance_to_critical(double cosine, double from, double to, int bits) {
  if (to >= from) return std::numeric_limits<double>::infinity();
  const MpfrInterval c(cosine, bits), one(1, bits);
  const MpfrInterval quotient = MpfrInterval(to, bits) / MpfrInterval(from, bits);
  const MpfrInterval distance = square(quotient) - (one - c) * (one + c);
  return std::fabs(mpfr_get_d(distance.lower().get(), MPFR_RNDN));
}

}  // namespace

ExactFresnel exact_fresnel_by_angles(double cosine, double from, double to, int bits) {
  require_interface(cosine, from, to);
  ExactFresnel result;
  const int side = side_of_critical(cosine, from, to);
  result.total_internal_reflection = side < 0;
  result.critical = side == 0;
  result.distance_to_critical = distance_to_critical(cosine, from, to, bits);
  if (side < 0) {
    result.reflectance = {1, 1};
    return result;
  }
  if (from == to) {
    result.refracted_cosine = {cosine, cosine};
    return result;
  }
  const MpfrInterval c(cosine, bits), one(1, bits), f(from, bits), t(to, bits);
  const MpfrInterval sine = sqrt((one - c) * (one + c));
  const MpfrInterval incident = decreasing(mpfr_acos, c);
  const MpfrInterval refracted = increasing(mpfr_asin, at_most(sine * f / t, 1));
  // Straight down both angles are zero and their quotients tell nothing; along the surface all is reflected.
  const MpfrInterval reflected = cosine == 1   ? square((f - t) / (f + t))
                                 : cosine == 0 ? one
                                               : reflectance_by_angles(incident, refracted, bits);
  result.refracted_cosine = settled_enclosure(decreasing(mpfr_cos, refracted));
  result.reflectance = settled_enclosure(reflected);
  return result;
}

namespace {

template <class Number>
using Triple = std::array<Number, 3>;

template <class Number>
Number dot(const Triple<Number>& a, const Triple<Number>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class Number>
Triple<Number> cross(const Triple<Number>& a, const Triple<Number>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// sin(refracted) along the surface and -cos(refracted) along the normal, one coordinate.
MpfrInterval refracted_coordinate(const Vec3& direction, const Vec3& normal, double from, double to, int axis,
                                  int bits) {
  const auto k = static_cast<std::size_t>(axis);
  const auto triple = [&](const Vec3& v) {
    return Triple<MpfrInterval>{MpfrInterval(v.x, bits), MpfrInterval(v.y, bits), MpfrInterval(v.z, bits)};
  };
  const Triple<MpfrInterval> d = triple(direction), n = triple(normal), across = cross(d, n);
  const MpfrInterval length = sqrt(dot(n, n)), across_length = sqrt(dot(across, across));
  if (across_length.is_zero()) return -n[k] / length;
  // n x (d x n), over its length, is the direction's part along the surface.
  const MpfrInterval along = cross(n, across)[k] / (length * across_length);
  const MpfrInterval sine =
      across_length / (sqrt(dot(d, d)) * length) * MpfrInterval(from, bits) / MpfrInterval(to, bits);
  const MpfrInterval angle = increasing(mpfr_asin, at_most(sine, 1));
  return increasing(mpfr_sin, angle) * along - decreasing(mpfr_cos, angle) * n[k] / length;
}

}  // namespace

std::optional<Vec3> exact_refracted_by_angles(const Vec3& direction, const Vec3& normal, double from, double to,
                                              int bits) {
  require_indices(from, to);
  require_vectors(direction, normal);
  const Triple<Integer> d{direction.x, direction.y, direction.z}, n{normal.x, normal.y, normal.z};
  if (dot(d, n) > 0) throw std::invalid_argument(kTowardsSurface);
  const Triple<Integer> across = cross(d, n);
  const Integer f(from), t(to);
  if (f * f * dot(across, across) > t * t * dot(d, d) * dot(n, n)) return std::nullopt;
  Vec3 result;
  for (int axis = 0; axis < 3; ++axis)
    for (;; bits *= 2) {
      const MpfrInterval coordinate = refracted_coordinate(direction, normal, from, to, axis, bits);
      const auto decided = decided_nearest(coordinate);
      if (!decided && bits < kLastBits) continue;
      result[axis] = decided ? *decided : mpfr_get_d(coordinate.lower().get(), MPFR_RNDN);
      break;
    }
  return result;
}

}  // namespace plumb
