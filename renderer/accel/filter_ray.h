#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "renderer/accel/bvh8_layout.h"
#include "renderer/accel/float4.h"
#include "renderer/math/ray.h"

namespace plumb {

/// The ends of a range, t >= 0, by at most three floats too wide; without a branch that the processor would have to
/// guess. The start is above 0, so that what lies behind it is not -0, and the end of a range that reaches 0 above that
/// start; the boxes' margin has room for the one, and the other only widens.
inline float wide_start(double t) {
  const float start = static_cast<float>(t) * (1 - 0x1p-23F);
  return start > 0x1p-120F ? start : 0x1p-120F;
}
inline float wide_end(double t) { return static_cast<float>(t) * (1 + 0x1p-22F) + 0x1p-119F; }

/// How far the numbers of a ray may be from those that it stands for, on each axis.
struct RayError {
  double origin = 0, direction = 0;
};

/// A ray in floats and in a tree's frame, with what the filters must allow for: docs/certified-kernel.md derives the
/// bounds.
struct FilterRay {
  /// The lanes are x, y, z and nothing. A plane at p is met at (p - near_origin) * reciprocal at the earliest, where it
  /// is the near one, and at (p - far_origin) * reciprocal at the latest, where it is the far one, all errors included.
  BoxSide near_origin, far_origin, reciprocal;
  /// Where the near and the far sides begin in those of an axis of Bvh8Node::sides, in bytes.
  LaneMask near_offset, far_offset;
  /// kx, ky and kz, the axis along which the direction is longest; and nothing.
  std::array<std::uint8_t, 4> axis;
  BoxSide origin;
  /// The direction over its longest coordinate.
  BoxSide shear;
  /// A weight is off by less than weight_error * (sum of the six |sheared coordinates|) + weight_error_constant.
  float weight_error, weight_error_constant;
  /// The reciprocal of the direction's longest coordinate, and how far off the t of a vertex' plane across that axis
  /// may be.
  float reciprocal_z, reciprocal_size_z, depth_error;
  /// The range in the frame, rounded outward; t_min > 0.
  float t_min, t_max;
  /// Every t of the frame from the one to the other lies in the range.
  float surely_from, surely_to;
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

/// kx, ky, kz by which of |x| > |y|, |y| > |z| and |z| > |x| hold, as bits from the lowest.
inline constexpr std::array<std::array<std::uint8_t, 4>, 8> kAxes{
    {{0, 1, 2, 0}, {1, 2, 0, 0}, {2, 0, 1, 0}, {1, 2, 0, 0}, {0, 1, 2, 0}, {0, 1, 2, 0}, {2, 0, 1, 0}, {0, 1, 2, 0}}};

/// Everything but the range, of a ray that is near the mesh and of moderate length.
[[gnu::always_inline]] inline void set_lines(FilterRay& filter, const FloatLine& line, float margin,
                                             float distance_error) {
  const auto& [o, d] = line;
  const BoxSide sizes = size_of(d);
  const BoxSide wider = with_signs(all(margin), d);
  const BoxSide reciprocal = 1 / with_signs(higher_of(sizes, 0x1p-36F * largest(sizes)), d);
  filter.reciprocal = reciprocal;
  filter.near_origin = o + wider;
  filter.far_origin = o - wider;
  constexpr std::int32_t kRow = sizeof(Bvh8Node::sides[0][0]);
  const LaneMask backward = std::bit_cast<LaneMask>(d) >> 31;
  filter.near_offset = backward & kRow;
  filter.far_offset = ~backward & kRow;
  filter.axis = kAxes[sign_bits(sizes > yzx(sizes)) & 7];
  filter.origin = o;
  filter.reciprocal_z = filter.reciprocal[filter.axis[2]];
  filter.shear = d * filter.reciprocal_z;
  const float reciprocal_size = std::fabs(filter.reciprocal_z);
  filter.reciprocal_size_z = reciprocal_size * (1 + 0x1p-20F);
  filter.depth_error = reciprocal_size * distance_error;
}

/// A ray of any size, or from far away.
FilterRay::Fate make_from_afar(const Ray& ray, const RayError& error, const FilterFrame& frame, FilterRay& filter);
/// The lines of a ray with errors; false where these are so large that the bounds' derivation does not hold.
bool set_rounded_lines(FilterRay& filter, const Point3& origin, const Vec3& direction, const RayError& error,
                       const FilterFrame& frame);

}  // namespace filter_ray

/// Fills `filter` for a ray in the mesh's coordinates; `misses` where the range is empty, the ray does not come near
/// the mesh, or a number is not finite. Of `unfiltered` nothing is filled in: every triangle has to be looked at.
[[gnu::always_inline]] inline FilterRay::Fate make_filter_ray(const Ray& ray, const RayError& error,
                                                              const FilterFrame& frame, FilterRay& filter) {
  using namespace filter_ray;
  using Doubles = double __attribute__((vector_size(32)));
  if (!frame.is_usable) return FilterRay::Fate::unfiltered;
  const Vec3& d = ray.direction;
  // By reference: a copy would load pairs of numbers that were stored one by one just before, which processors are slow
  // at.
  Point3 in_frame;
  const Point3& o = frame.is_identity ? ray.origin : (in_frame = frame(ray.origin));
  const FloatLine line{__builtin_convertvector((Doubles{o.x, o.y, o.z, 0}), BoxSide),
                       __builtin_convertvector((Doubles{d.x, d.y, d.z, 0}), BoxSide)};
  const BoxSide sizes = size_of(line.direction);
  // What is false of NaN.
  const LaneMask moderate =
      (sizes < all(0x1p30F)) & (largest(sizes) > all(0x1p-30F)) & (size_of(line.origin) <= all(frame.near));
  if (!((sign_bits(moderate) & 7) == 7 && ray.t_min >= 0 && ray.t_min <= ray.t_max))
    return make_from_afar(ray, error, frame, filter);
  filter.t_factor = frame.factor;
  filter.t_start = 0;
  filter.t_min = wide_start(ray.t_min * frame.factor);
  filter.t_max = wide_end(ray.t_max * frame.factor);
  filter.surely_from = filter.t_min * (1 + 0x1p-20F);
  filter.surely_to = filter.t_max * (1 - 0x1p-20F) - 0x1p-118F;
  // Whether a coordinate has more digits than a float.
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
  const bool is_float = ((bits(o.x) | bits(o.y) | bits(o.z) | bits(d.x) | bits(d.y) | bits(d.z)) & 0x1fffffff) == 0;
  if (is_float && frame.is_identity && bits(error.origin + error.direction) == 0) {
    filter.weight_error = frame.weight_error;
    filter.weight_error_constant = frame.weight_error_constant;
    set_lines(filter, line, frame.margin, frame.distance_error);
    return FilterRay::Fate::walk;
  }
  return set_rounded_lines(filter, o, d, error, frame) ? FilterRay::Fate::walk : FilterRay::Fate::unfiltered;
}

}  // namespace plumb
