#include <cmath>
#include <ranges>

#include "reference/exact_transform_affine.h"
#include "reference/exact_transform_cross_check.h"
#include "reference/mpfr_interval.h"

namespace plumb {
namespace {

struct IntervalCosSin {
  MpfrInterval cos, sin;
};

/// Of an angle from 0 to below 90 degrees over `parts`.
IntervalCosSin within_right_angle(double degrees, int parts, int bits) {
  const MpfrInterval one(1, bits), half(0.5, bits);
  if (degrees == 0) return {one, {}};
  const MpfrInterval angle = MpfrInterval(degrees, bits) * MpfrInterval::pi(bits) / MpfrInterval(180.0 * parts, bits);
  IntervalCosSin result{decreasing(mpfr_cos, angle), increasing(mpfr_sin, angle)};
  if (degrees == 30.0 * parts) result.sin = half;
  if (degrees == 60.0 * parts) result.cos = half;
  return result;
}

/// Of `degrees` / `parts`, where the angle that is divided stays exact.
IntervalCosSin cos_sin_by_radians(double degrees, int parts, int bits) {
  // Both remainders are exact, and so is their difference: a multiple of the right angle.
  const double right = 90.0 * parts;
  const double turned = std::fmod(degrees, 4 * right), rest = std::fmod(degrees, right);
  IntervalCosSin result = within_right_angle(std::fabs(rest), parts, bits);
  if (rest < 0) result.sin = -result.sin;
  for (int quarter = (static_cast<int>((turned - rest) / right) + 4) % 4; quarter > 0; --quarter)
    result = {-result.sin, result.cos};
  return result;
}

struct Quaternion {
  MpfrInterval w, x, y, z;
};

Quaternion operator*(const Quaternion& a, const Quaternion& b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

Quaternion about_axis(int axis, double degrees, int bits) {
  const IntervalCosSin half = cos_sin_by_radians(degrees, 2, bits);
  Quaternion result{half.cos, {}, {}, {}};
  (axis == 0 ? result.x : axis == 1 ? result.y : result.z) = half.sin;
  return result;
}

struct QuaternionNumbers {
  using Number = MpfrInterval;
  int bits;

  Number of(double x) const { return {x, bits}; }
  Affine<Number> rotation(const Vec3& degrees) const {
    const Quaternion q =
        about_axis(2, degrees.z, bits) * (about_axis(1, degrees.y, bits) * about_axis(0, degrees.x, bits));
    const Number two = of(2);
    const Number ww = square(q.w), xx = square(q.x), yy = square(q.y), zz = square(q.z);
    Affine<Number> result;
    result[0] = {ww + xx - yy - zz, two * (q.x * q.y - q.w * q.z), two * (q.x * q.z + q.w * q.y), {}};
    result[1] = {two * (q.x * q.y + q.w * q.z), ww - xx + yy - zz, two * (q.y * q.z - q.w * q.x), {}};
    result[2] = {two * (q.x * q.z - q.w * q.y), two * (q.y * q.z + q.w * q.x), ww - xx - yy + zz, {}};
    return result;
  }
};

Affine<MpfrInterval> product_from_the_right(std::span<const TransformStep> steps, int bits) {
  const QuaternionNumbers numbers{bits};
  Affine<MpfrInterval> result = step_matrix(numbers, TransformStep{});
  for (const TransformStep& step : std::views::reverse(steps)) result = product(step_matrix(numbers, step), result);
  return result;
}

}  // namespace

EnclosedCosSin certified_cos_sin_by_radians(double degrees, int bits) {
  if (!std::isfinite(degrees)) return {kUnknown, kUnknown};
  const IntervalCosSin result = cos_sin_by_radians(degrees, 1, bits);
  return {settled_enclosure(result.cos), settled_enclosure(result.sin)};
}

EnclosedMatrix certified_product_by_quaternions(std::span<const TransformStep> steps, int bits) {
  if (!all_finite(steps)) return unknown_matrix();
  return enclose_entries(product_from_the_right(steps, bits), settled_enclosure);
}

bool certified_inverse_by_quaternions(std::span<const TransformStep> steps, int bits, EnclosedMatrix& inverse) {
  inverse = unknown_matrix();
  if (!all_finite(steps) || flattens(steps)) return false;
  const Affine<MpfrInterval> a = product_from_the_right(steps, bits);
  const auto adjugate_of_a = adjugate(a);
  MpfrInterval determinant;
  for (std::size_t k = 0; k < 3; ++k) determinant = determinant + a[0][k] * adjugate_of_a[k][0];
  for (std::size_t i = 0; i < 3; ++i) {
    MpfrInterval moved;
    for (std::size_t j = 0; j < 3; ++j) {
      inverse[i][j] = settled_enclosure(adjugate_of_a[i][j] / determinant);
      moved = moved - adjugate_of_a[i][j] * a[j][3];
    }
    inverse[i][3] = settled_enclosure(moved / determinant);
  }
  return true;
}

}  // namespace plumb
