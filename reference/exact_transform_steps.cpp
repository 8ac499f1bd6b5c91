#include <gmpxx.h>

#include <algorithm>
#include <cmath>

#include "reference/exact_transform.h"
#include "reference/exact_transform_affine.h"
#include "reference/mpfr_interval.h"

namespace plumb {
namespace {

constexpr int kFirstBits = 256, kLastBits = 2048;

using FunctionOfTurn = int (*)(mpfr_ptr, mpfr_srcptr, unsigned long, mpfr_rnd_t);

/// mpfr_cosu or mpfr_sinu in 360ths of a turn: correctly rounded, so that one rounding tells both.
MpfrInterval of_degrees(FunctionOfTurn function, double degrees, int bits) {
  const MpfrNumber angle = MpfrInterval(degrees, 53).lower();
  MpfrNumber lower(bits);
  const int direction = function(lower.get(), angle.get(), 360, MPFR_RNDD);
  MpfrNumber upper = lower;
  if (direction != 0) mpfr_nextabove(upper.get());
  return {std::move(lower), std::move(upper)};
}

/// Rz Ry Rx of cosines and sines that `numbers` gives.
template <class Numbers>
auto rotation_of(const Numbers& numbers, const Vec3& degrees) {
  const auto about = [&](int axis) {
    const double angle = degrees[axis];
    return axis_rotation(static_cast<std::size_t>(axis), numbers.of(1), numbers.cos(angle), numbers.sin(angle));
  };
  return product(product(about(2), about(1)), about(0));
}

struct IntervalNumbers {
  using Number = MpfrInterval;
  int bits;

  Number of(double x) const { return {x, bits}; }
  Number cos(double degrees) const { return of_degrees(mpfr_cosu, degrees, bits); }
  Number sin(double degrees) const { return of_degrees(mpfr_sinu, degrees, bits); }
  Affine<Number> rotation(const Vec3& degrees) const { return rotation_of(*this, degrees); }
};

/// For rotations by multiples of 90 degrees.
struct RationalNumbers {
  using Number = mpq_class;

  Number of(double x) const { return x; }
  Number cos(double degrees) const { return sin(std::fmod(degrees, 360) + 90); }
  Number sin(double degrees) const {
    const double turned = std::fmod(degrees, 360);
    const double angle = turned < 0 ? turned + 360 : turned;
    return angle == 90 ? 1 : angle == 270 ? -1 : 0;
  }
  Affine<Number> rotation(const Vec3& degrees) const { return rotation_of(*this, degrees); }
};

bool is_right_angle(double degrees) { return std::fmod(degrees, 90) == 0; }

bool all_rational(std::span<const TransformStep> steps) {
  return std::ranges::all_of(steps, [](const TransformStep& step) {
    return step.kind != TransformStep::Kind::rotate ||
           (is_right_angle(step.value.x) && is_right_angle(step.value.y) && is_right_angle(step.value.z));
  });
}

template <class Numbers>
auto identity(const Numbers& numbers) {
  return step_matrix(numbers, TransformStep{TransformStep::Kind::translate, {}});
}

template <class Numbers>
auto product_of(const Numbers& numbers, std::span<const TransformStep> steps) {
  auto result = identity(numbers);
  for (const TransformStep& step : steps) result = product(result, step_matrix(numbers, step));
  return result;
}

/// Of one step with no factor of zero: the other way, back, or by the reciprocals.
template <class Numbers>
auto inverse_step_matrix(const Numbers& numbers, const TransformStep& step) {
  if (step.kind == TransformStep::Kind::translate) return step_matrix(numbers, TransformStep{step.kind, -step.value});
  auto result = step_matrix(numbers, step);
  if (step.kind == TransformStep::Kind::rotate)
    transpose_linear_part(result);
  else
    for (std::size_t i = 0; i < 3; ++i) result[i][i] = numbers.of(1) / result[i][i];
  return result;
}

template <class Numbers>
auto inverse_of(const Numbers& numbers, std::span<const TransformStep> steps) {
  auto result = identity(numbers);
  for (const TransformStep& step : steps) result = product(inverse_step_matrix(numbers, step), result);
  return result;
}

/// Exactly where all is rational; else by `compute(numbers)` in intervals, the precision doubled until all is decided.
template <class Compute>
EnclosedMatrix certified(std::span<const TransformStep> steps, const Compute& compute) {
  if (all_rational(steps)) return enclose_entries(compute(RationalNumbers{}), enclose);
  for (int bits = kFirstBits;; bits *= 2) {
    const Affine<MpfrInterval> intervals = compute(IntervalNumbers{bits});
    if (bits == kLastBits) return enclose_entries(intervals, settled_enclosure);
    const bool decided = std::ranges::all_of(intervals, [](const auto& row) {
      return std::ranges::all_of(row, [](const MpfrInterval& entry) { return decided_enclosure(entry).has_value(); });
    });
    if (decided) return enclose_entries(intervals, widest_enclosure);
  }
}

}  // namespace

EnclosedCosSin certified_cos_sin(double degrees) {
  if (!std::isfinite(degrees)) return {kUnknown, kUnknown};
  return {widest_enclosure(of_degrees(mpfr_cosu, degrees, 53)), widest_enclosure(of_degrees(mpfr_sinu, degrees, 53))};
}

EnclosedMatrix certified_product(std::span<const TransformStep> steps) {
  if (!all_finite(steps)) return unknown_matrix();
  return certified(steps, [&](const auto& numbers) { return product_of(numbers, steps); });
}

bool certified_inverse(std::span<const TransformStep> steps, EnclosedMatrix& inverse) {
  inverse = unknown_matrix();
  if (!all_finite(steps) || flattens(steps)) return false;
  inverse = certified(steps, [&](const auto& numbers) { return inverse_of(numbers, steps); });
  return true;
}

}  // namespace plumb
