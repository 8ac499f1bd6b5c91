#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "renderer/accel/bvh8_layout.h"
#include "renderer/accel/float4.h"
#include "renderer/math/placed_ray.h"

namespace plumb {

/// The ends of a range, t >= 0, by at most three floats too wide; without a branch that the processor would have to
/// guess. The start is above 0, so that what lies behind it is not -0, and the end of a range that reaches 0 above that
/// start; the boxes' margin has room for the one, and the other only widens.
inline float wide_start(double t) {
  const float start = static_cast<float>(t) * (1 - 0x1p-23F);
  return start > 0x1p-120F ? start : 0x1p-120F;
}
inline float wide_end(double t) { return static_cast<float>(t) * (1 + 0x1p-22F) + 0x1p-119F; }

/// The range in a tree's frame.
struct FilterRange {
  /// Rounded outward; t_min > 0.
  float t_min, t_max;
  /// Every t of the frame from the one to the other lies in the range.
  float surely_from, surely_to;
};

/// A ray as boxes are tested against it. The lanes are x, y, z and nothing. A plane at p is met at
/// (p - near_origin) * reciprocal at the earliest, where it is the near one, and at (p - far_origin) * reciprocal at
/// the latest, where it is the far one, all errors included.
struct BoxRay {
  BoxSide near_origin, far_origin, reciprocal;
};

/// A ray in floats and in a tree's frame, with what the filters must allow for: docs/certified-kernel.md derives the
/// bounds.
struct FilterRay {
  /// Where the near and the far sides begin in those of an axis of Bvh8Node::sides, in bytes.
  LaneMask near_offset, far_offset;
  /// kx, ky and kz, the axis along which the direction is longest; and nothing. Lanes below are in their order.
  LaneMask axis;
  /// Where these axes begin in Bvh8Leaf::vertices, in bytes.
  LaneMask row;
  BoxSide origin;
  /// The direction over its longest coordinate.
  BoxSide shear;
  /// A weight is off by less than weight_error * (sum of the six |sheared coordinates|) + weight_error_constant.
  float weight_error, weight_error_constant;
  /// The reciprocal of the direction's longest coordinate, and how far off the t of a vertex' plane across that axis
  /// may be.
  float reciprocal_z, reciprocal_size_z, depth_error;
  FilterRange range;
  /// frame t = (t - t_start) * t_factor, for an end of the range.
  double t_start, t_factor;

  /// A float that is not below the frame's t, by at most some units of its last place.
  float frame_t_max(double t) const {
    // Nearly every ray starts where it is.
    if (t_start == 0) return wide_end(t * t_factor);
    return wide_end((t - t_start) * t_factor + 0x1p-50 * (std::fabs(t) + std::fabs(t_start)) * t_factor);
  }

  /// `unfiltered`: the ray, or the way to it, has too few digits or too large numbers for bounds in floats to mean
  /// anything.
  enum class Fate { walk, misses, unfiltered };
};

/// Fills in the bounds of a frame whose reach and vertex_error are known.
void set_filter_errors(FilterFrame& frame);

/// What make_filter_ray is made of. Its usual way is inlined into the walk of each instruction set.
namespace filter_ray {

using Doubles = double __attribute__((vector_size(32)));

/// The digits that a double has and a float has not.
constexpr std::int64_t kMoreDigits = 0x1fffffff;
constexpr LaneMask kSign{INT32_MIN, INT32_MIN, INT32_MIN, INT32_MIN};

[[gnu::always_inline]] inline BoxSide all(float value) { return BoxSide{value, value, value, value}; }
[[gnu::always_inline]] inline BoxSide size_of(BoxSide v) {
  return std::bit_cast<BoxSide>(std::bit_cast<LaneMask>(v) & ~kSign);
}
[[gnu::always_inline]] inline BoxSide with_signs(BoxSide size, BoxSide of) {
  return std::bit_cast<BoxSide>(std::bit_cast<LaneMask>(size) | (std::bit_cast<LaneMask>(of) & kSign));
}
[[gnu::always_inline]] inline BoxSide yzx(BoxSide v) { return __builtin_shufflevector(v, v, 1, 2, 0, 3); }
[[gnu::always_inline]] inline BoxSide zxy(BoxSide v) { return __builtin_shufflevector(v, v, 2, 0, 1, 3); }
/// The largest of the first three, in each of these.
[[gnu::always_inline]] inline BoxSide largest(BoxSide v) { return higher_of(higher_of(v, yzx(v)), zxy(v)); }

/// What the fourth lanes hold means nothing.
struct FloatLine {
  BoxSide origin, direction;
};

/// kx, ky, kz by which of |x| > |y|, |x| > |z| and |y| > |z| hold, as bits from the lowest; as longest_axis().
inline constexpr std::array<LaneMask, 8> kAxes{
    {{0, 1, 2, 3}, {0, 1, 2, 3}, {0, 1, 2, 3}, {1, 2, 0, 3}, {2, 0, 1, 3}, {2, 0, 1, 3}, {2, 0, 1, 3}, {1, 2, 0, 3}}};

/// Of a range with t_min >= 0, all at once: the ends as by wide_start and wide_end, and these moved inward by 2^-20.
[[gnu::always_inline]] inline FilterRange range_of(const Ray& ray, double factor) {
  const BoxSide ends = __builtin_convertvector((Doubles{ray.t_min, ray.t_max, ray.t_min, ray.t_max} * factor), BoxSide);
  constexpr float kIn = 1 - 0x1p-23F, kOut = 1 + 0x1p-22F;
  const BoxSide wide = higher_of(ends * BoxSide{kIn, kOut, kIn, kOut} + BoxSide{0, 0x1p-119F, 0, 0x1p-119F},
                                 BoxSide{0x1p-120F, 0, 0x1p-120F, 0});
  return std::bit_cast<FilterRange>(wide * BoxSide{1, 1, 1 + 0x1p-20F, 1 - 0x1p-20F} - BoxSide{0, 0, 0, 0x1p-118F});
}

/// Everything but the range, of a ray that is near the mesh and of moderate length: its longest coordinate is above
/// 2^-30. What it moves on an axis where it moves less than 2^-66, while it is near the mesh, is in the margin.
[[gnu::always_inline]] inline BoxRay set_lines(FilterRay& filter, const FloatLine& line, float margin,
                                               float distance_error) {
  const auto& [o, d] = line;
  const BoxSide sizes = size_of(d);
  const BoxSide wider = with_signs(all(margin), d);
  const BoxSide reciprocal = 1 / with_signs(higher_of(sizes, all(0x1p-66F)), d);
  constexpr std::int32_t kRow = sizeof(Bvh8Node::sides[0][0]);
  const LaneMask backward = std::bit_cast<LaneMask>(d) >> 31;
  filter.near_offset = backward & kRow;
  filter.far_offset = ~backward & kRow;
  const BoxSide xxy = __builtin_shufflevector(sizes, sizes, 0, 0, 1, 3),
                yzz = __builtin_shufflevector(sizes, sizes, 1, 2, 2, 3);
  filter.axis = kAxes[sign_bits(xxy > yzz) & 7];
  filter.row = filter.axis * static_cast<std::int32_t>(sizeof(Bvh8Leaf::vertices[0]));
  filter.origin = taken(o, filter.axis);
  const BoxSide ordered = taken(reciprocal, filter.axis), z = __builtin_shufflevector(ordered, ordered, 2, 2, 2, 2);
  filter.shear = taken(d, filter.axis) * z;
  filter.reciprocal_z = z[0];
  const float reciprocal_size = std::fabs(z[0]);
  filter.reciprocal_size_z = reciprocal_size * (1 + 0x1p-20F);
  filter.depth_error = reciprocal_size * distance_error;
  return {o + wider, o - wider, reciprocal};
}

/// A ray of any size, or from far away.
FilterRay::Fate make_from_afar(const PlacedRay& placed, const FilterFrame& frame, FilterRay& filter, BoxRay& boxes);
/// The lines of a ray with errors, whose origin is that in the frame; false where these are so large that the bounds'
/// derivation does not hold.
bool set_rounded_lines(FilterRay& filter, BoxRay& boxes, const PlacedRay& placed, const Point3& origin,
                       const FilterFrame& frame);

}  // namespace filter_ray

/// Fills `filter` and `boxes` for a ray in the mesh's coordinates; `misses` where the range is empty, the ray does not
/// come near the mesh, or a number is not finite. Of `unfiltered` nothing is filled in: every triangle has to be looked
/// at.
[[gnu::always_inline]] inline FilterRay::Fate make_filter_ray(const PlacedRay& placed, const FilterFrame& frame,
                                                              FilterRay& filter, BoxRay& boxes) {
  using namespace filter_ray;
  using Bits = std::int64_t __attribute__((vector_size(32)));
  const Ray& ray = placed.object();
  const Vec3& d = ray.direction;
  const Doubles direction{d.x, d.y, d.z, 0};
  Doubles origin{ray.origin.x, ray.origin.y, ray.origin.z, 0};
  const LaneMask more_digits = __builtin_convertvector(
      (reinterpret_cast<Bits>(origin) | reinterpret_cast<Bits>(direction)) & kMoreDigits, LaneMask);
  if (!frame.is_identity) origin = (origin - Doubles{frame.center.x, frame.center.y, frame.center.z, 0}) * frame.factor;
  const FloatLine line{__builtin_convertvector(origin, BoxSide), __builtin_convertvector(direction, BoxSide)};
  const BoxSide sizes = size_of(line.direction);
  // What is false of NaN.
  const LaneMask moderate =
      (sizes < all(0x1p30F)) & (largest(sizes) > all(0x1p-30F)) & (size_of(line.origin) <= all(frame.near));
  const auto of_all = [](LaneMask mask) { return (sign_bits(mask) & 7) == 7; };
  const bool is_float = of_all(moderate & (more_digits == 0));
  if (!((is_float || of_all(moderate)) && ray.t_min >= 0 && ray.t_min <= ray.t_max)) {
    BoxRay made;  // so that `boxes` may be kept in registers
    const FilterRay::Fate fate = make_from_afar(placed, frame, filter, made);
    boxes = made;
    return fate;
  }
  filter.t_factor = frame.factor;
  filter.t_start = 0;
  filter.range = range_of(ray, frame.factor);
  if (is_float && frame.is_identity && placed.is_exact()) {
    filter.weight_error = frame.weight_error;
    filter.weight_error_constant = frame.weight_error_constant;
    boxes = set_lines(filter, line, frame.margin, frame.distance_error);
    return FilterRay::Fate::walk;
  }
  BoxRay made;
  const bool has_bounds = set_rounded_lines(filter, made, placed, {origin[0], origin[1], origin[2]}, frame);
  boxes = made;
  return has_bounds ? FilterRay::Fate::walk : FilterRay::Fate::unfiltered;
}

}  // namespace plumb
