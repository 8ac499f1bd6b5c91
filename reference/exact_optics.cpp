#include "reference/exact_optics.h"

#include <gmpxx.h>

#include <array>

#include "reference/exact_optics_domain.h"
#include "reference/mpfr_interval.h"

namespace plumb {
namespace {

/// What is not rational here is irrational, and so is decided long before the last precision: the indices' squared
/// quotient can take 4200 bits to tell from zero.
constexpr int kFirstBits = 256, kLastBits = 16384;

mpq_class square(const mpq_class& x) { return x * x; }

/// The root of a fraction that is a square of one; x must not be negative.
std::optional<mpq_class> rational_root(const mpq_class& x) {
  if (!mpz_perfect_square_p(x.get_num_mpz_t()) || !mpz_perfect_square_p(x.get_den_mpz_t())) return std::nullopt;
  return mpq_class(sqrt(x.get_num()), sqrt(x.get_den()));
}

/// [Shirley 13.1], unpolarised: the mean of both polarisations. `refracted` is the cosine on the far side.
template <class Number>
Number reflectance(const Number& cosine, const Number& refracted, const Number& from, const Number& to,
                   const Number& half) {
  const Number perpendicular = (from * cosine - to * refracted) / (from * cosine + to * refracted);
  const Number parallel = (from * refracted - to * cosine) / (from * refracted + to * cosine);
  return half * (square(perpendicular) + square(parallel));
}

/// Fills in the reflectance and the cosine of what is refracted, whose squared cosine is `squared`.
void refract(const mpq_class& cosine, const mpq_class& squared, const mpq_class& from, const mpq_class& to,
             ExactFresnel& result) {
  if (const auto refracted = rational_root(squared)) {
    result.refracted_cosine = enclose(*refracted);
    result.reflectance = enclose(reflectance<mpq_class>(cosine, *refracted, from, to, mpq_class(1, 2)));
    return;
  }
  // The root is irrational, and with it the reflectance unless the cosine is zero: in
  // (a - b s)^4 / (a^2 - b^2 s^2)^2 the odd powers of s come to -4 a b s (a^2 + b^2 s^2), negative for both
  // polarisations.
  for (int bits = kFirstBits;; bits *= 2) {
    const MpfrInterval refracted = sqrt(MpfrInterval(squared, bits));
    const MpfrInterval reflected = cosine == 0
                                       ? MpfrInterval(1, bits)
                                       : reflectance(MpfrInterval(cosine, bits), refracted, MpfrInterval(from, bits),
                                                     MpfrInterval(to, bits), MpfrInterval(0.5, bits));
    if (bits < kLastBits && !(decided_enclosure(refracted) && decided_enclosure(reflected))) continue;
    result.refracted_cosine = widest_enclosure(refracted);
    result.reflectance = widest_enclosure(reflected);
    return;
  }
}

}  // namespace

ExactFresnel exact_fresnel(double cosine, double from, double to) {
  require_interface(cosine, from, to);
  const mpq_class sine_squared = 1 - square(mpq_class(cosine));
  const mpq_class critical = square(mpq_class(to) / mpq_class(from));
  ExactFresnel result;
  result.total_internal_reflection = sine_squared > critical;
  result.critical = sine_squared == critical;
  result.distance_to_critical =
      to < from ? nearest(abs(critical - sine_squared)) : std::numeric_limits<double>::infinity();
  if (result.total_internal_reflection)
    result.reflectance = {1, 1};
  else if (from == to)
    result.refracted_cosine = {cosine, cosine};
  else
    refract(cosine, 1 - sine_squared / critical, from, to, result);
  return result;
}

namespace {

using Triple = std::array<mpq_class, 3>;

Triple exact(const Vec3& v) { return {v.x, v.y, v.z}; }
mpq_class dot(const Triple& a, const Triple& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// With both vectors scaled to unit length by their `lengths` (of direction, then normal) and the far cosine
/// `refracted`: ratio d + (ratio cos - refracted) n.
template <class Number>
struct Refraction {
  Number ratio, cosine, refracted, direction_length, normal_length;

  Number coordinate(const Number& direction, const Number& normal) const {
    return ratio * direction / direction_length + (ratio * cosine - refracted) * normal / normal_length;
  }
};

/// The nearest double of what `compute(bits)` encloses. What the last precision cannot tell lies on the border between
/// two doubles, for all that is known: either is nearest.
template <class Compute>
double nearest_by_intervals(const Compute& compute) {
  for (int bits = kFirstBits;; bits *= 2) {
    const MpfrInterval interval = compute(bits);
    if (const auto decided = decided_nearest(interval)) return *decided;
    if (bits == kLastBits) return mpfr_get_d(interval.lower().get(), MPFR_RNDN);
  }
}

}  // namespace

std::optional<Vec3> exact_refracted(const Vec3& direction, const Vec3& normal, double from, double to) {
  require_indices(from, to);
  require_vectors(direction, normal);
  const Triple d = exact(direction), n = exact(normal);
  const mpq_class towards = -dot(d, n), dd = dot(d, d), nn = dot(n, n);
  if (towards < 0) throw std::invalid_argument(kTowardsSurface);
  const mpq_class ratio = mpq_class(from) / mpq_class(to);
  const mpq_class squared = 1 - square(ratio) * (1 - square(towards) / (dd * nn));
  if (squared < 0) return std::nullopt;

  Vec3 result;
  const auto root_d = rational_root(dd), root_n = rational_root(nn), refracted = rational_root(squared);
  if (root_d && root_n && refracted) {
    const Refraction<mpq_class> exactly{ratio, towards / (*root_d * *root_n), *refracted, *root_d, *root_n};
    for (int axis = 0; axis < 3; ++axis) {
      const auto k = static_cast<std::size_t>(axis);
      result[axis] = nearest(exactly.coordinate(d[k], n[k]));
    }
    return result;
  }
  for (int axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    result[axis] = nearest_by_intervals([&](int bits) {
      const MpfrInterval length_d = sqrt(MpfrInterval(dd, bits)), length_n = sqrt(MpfrInterval(nn, bits));
      const Refraction<MpfrInterval> about{MpfrInterval(ratio, bits),
                                           MpfrInterval(towards, bits) / (length_d * length_n),
                                           sqrt(MpfrInterval(squared, bits)), length_d, length_n};
      return about.coordinate(MpfrInterval(d[k], bits), MpfrInterval(n[k], bits));
    });
  }
  return result;
}

}  // namespace plumb
