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
inline float wide_start(double t) { return std::max(static_cast<float>(t) * (1 - 0x1p-23F), 0x1p-120F); }
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
  /// The direction's longest axis, and the two others.
  std::array<std::uint8_t, 3> axis;  // kx, ky, kz
  /// Per axis of space: which row of Bvh8Node::sides holds the near ones.
  std::int32_t __attribute__((vector_size(16))) near_row;
  /// The origin by `axis`, and the shear.
  std::array<float, 3> origin;
  float shear_x, shear_y;
  /// A weight is off by less than weight_error * (sum of the six |sheared coordinates|) + weight_error_constant.
  float weight_error, weight_error_constant;
  /// The reciprocal of the direction's longest coordinate, and how far off the t of a vertex' plane across that axis
  /// may be.
  float reciprocal_z, reciprocal_size_z, depth_error;
  /// The range in the frame, rounded outward; t_min > 0.
  float t_min, t_max;
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

/// Fills `filter` for a ray in the mesh's coordinates; `misses` where the range is empty, the ray does not come near
/// the mesh, or a number is not finite. Of `unfiltered` nothing is filled in: every triangle has to be looked at.
FilterRay::Fate make_filter_ray(const Ray& ray, const RayError& error, const FilterFrame& frame, FilterRay& filter);

}  // namespace plumb
