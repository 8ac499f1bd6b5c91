#include "renderer/accel/filter_ray.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace plumb {
namespace {

constexpr double kLargestDouble = std::numeric_limits<double>::max();
constexpr double kU = 0x1p-24;  // the largest relative rounding of a float
/// Rays from farther away than 4 reaches are moved near first, to about one, or are not filtered: no vertex is farther
/// than this from an origin, on an axis, in reaches.
constexpr double kFarthest = 5.001;

template <class Triple>
double largest(const Triple& v) {
  return std::max(std::fabs(v.x), std::max(std::fabs(v.y), std::fabs(v.z)));
}

/// How far the numbers of a ray may be from those that it stands for, on each axis.
struct RayError {
  double origin = 0, direction = 0;
};

/// A ray in the frame, in doubles, and the most that any of its coordinates is off.
struct FrameRay {
  Point3 origin;
  Vec3 direction;
  RayError error;
  double t_min, t_max;
};

/// Moves the origin to where the ray comes near the mesh: the closer it is, the less its coordinates are rounded.
/// Nothing is left where the ray passes by. `moved` is how far t was moved.
bool move_near(FrameRay& ray, const FilterFrame& frame, double& moved) {
  const double far = largest(ray.origin);
  const double along = largest(ray.direction);
  // Room for the rounding of the ends below (2^-50 of the way there) and for the ray's own error on that way.
  const double side = 1.001 * frame.reach + 2 * frame.vertex_error + 2 * ray.error.origin +
                      (far + frame.reach) * (0x1p-45 + 4 * ray.error.direction / along);
  double near = ray.t_min, end = ray.t_max;
  for (int axis = 0; axis < 3; ++axis) {
    const double o = ray.origin[axis], d = ray.direction[axis];
    if (std::fabs(d) < 0x1p-40 * along) {  // hardly moves on this axis while it is near the others
      if (std::fabs(o) > side + (far + side) * 0x1p-39) return false;
      continue;
    }
    const double a = (-side - o) / d, b = (side - o) / d;
    near = std::max(near, std::min(a, b));
    end = std::min(end, std::max(a, b));
  }
  if (!(near <= end) || !std::isfinite(near)) return false;
  ray.origin = ray.origin + near * ray.direction;
  ray.error.origin += std::fabs(near) * ray.error.direction + 0x1p-50 * (far + largest(ray.origin));
  ray.t_min -= near;
  ray.t_max -= near;
  moved = near;
  return true;
}

/// The bounds of the filters, in the frame: `offset` is how far the float origin and the float vertices may be off,
/// `slant` how far the direction, in units of its largest coordinate.
void set_errors(FilterRay& filter, const FilterFrame& frame, double offset, double slant, float& margin,
                float& distance_error) {
  // Of a vertex from the origin, on an axis.
  const double reach = kFarthest * frame.reach;
  // A thousandth more, for products of these errors with the direction's, which is 2^-12 at most.
  const double moved = (offset + frame.vertex_error) * 1.001;
  const double sheared = 7.5 * kU * reach + 2.001 * moved + 2.1 * slant * reach;
  const double weight = (sheared + 4 * kU * reach) * (1 + 0x1p-19);
  filter.weight_error = static_cast<float>(weight);
  filter.weight_error_constant = static_cast<float>(2.01 * weight * weight);
  // Boxes: the errors of the ray and of a vertex, the direction's over the way to it, and 8u for the arithmetic.
  margin = static_cast<float>(moved + slant * reach * 1.01 + 8.5 * kU * reach);
  distance_error = static_cast<float>(3 * moved + 24 * kU * reach + 3.2 * slant * reach);
}

/// Of a ray in doubles, with the errors of rounding it and those that it has already.
bool set_lines(FilterRay& filter, BoxRay& boxes, const FrameRay& ray, const FilterFrame& frame) {
  const Point3& o = ray.origin;
  const Vec3& d = ray.direction;
  const filter_ray::FloatLine line{
      BoxSide{static_cast<float>(o.x), static_cast<float>(o.y), static_cast<float>(o.z), 0},
      BoxSide{static_cast<float>(d.x), static_cast<float>(d.y), static_cast<float>(d.z), 0}};
  const auto off = [](const auto& exact, BoxSide rounded) {
    return std::max(std::fabs(exact.x - static_cast<double>(rounded[0])),
                    std::max(std::fabs(exact.y - static_cast<double>(rounded[1])),
                             std::fabs(exact.z - static_cast<double>(rounded[2]))));
  };
  const float along = filter_ray::largest(filter_ray::size_of(line.direction))[0];
  const double offset = ray.error.origin + off(ray.origin, line.origin),
               slant = ray.error.direction + off(ray.direction, line.direction);
  if (!(offset <= frame.reach && slant <= 0x1p-12 * static_cast<double>(along))) return false;
  float margin = 0, distance_error = 0;
  set_errors(filter, frame, offset, slant / static_cast<double>(along), margin, distance_error);
  boxes = filter_ray::set_lines(filter, line, margin, distance_error);
  return true;
}

}  // namespace

namespace filter_ray {

bool set_rounded_lines(FilterRay& filter, BoxRay& boxes, const PlacedRay& placed, const Point3& origin,
                       const FilterFrame& frame) {
  FrameRay ray{origin, placed.object().direction, {placed.origin_error * frame.factor, placed.direction_error}, 0, 0};
  if (frame.center != Point3{}) ray.error.origin += 0x1p-53 * plumb::largest(origin);
  return set_lines(filter, boxes, ray, frame);
}

FilterRay::Fate make_from_afar(const PlacedRay& placed, const FilterFrame& frame, FilterRay& filter, BoxRay& boxes) {
  const Ray& ray = placed.object();
  if (!frame.is_usable) return FilterRay::Fate::unfiltered;
  const double length = plumb::largest(ray.direction), distance = plumb::largest(ray.origin);
  const double sum = ray.origin.x + ray.origin.y + ray.origin.z + ray.direction.x + ray.direction.y + ray.direction.z;
  if (!(ray.t_min <= ray.t_max)) return FilterRay::Fate::misses;
  // NaN fails every comparison, or makes the sum one. A ray that was taken to another frame may have lost its direction
  // on the way.
  if (std::isnan(sum) || !(length > 0 && length <= kLargestDouble && distance <= kLargestDouble))
    return placed.is_exact() ? FilterRay::Fate::misses : FilterRay::Fate::unfiltered;
  if (!(length >= 0x1p-400 && length <= 0x1p400)) return FilterRay::Fate::unfiltered;
  const double shorten = std::scalbn(1.0, -std::ilogb(length));
  FrameRay moved{frame(ray.origin),
                 shorten * ray.direction,
                 {placed.origin_error * frame.factor, placed.direction_error * shorten},
                 0,
                 0};
  if (!(plumb::largest(moved.origin) <= 0x1p60)) return FilterRay::Fate::unfiltered;
  if (frame.center != Point3{}) moved.error.origin += 0x1p-53 * plumb::largest(moved.origin);
  filter.t_factor = frame.factor / shorten;
  moved.t_min = ray.t_min * filter.t_factor;
  moved.t_max = ray.t_max * filter.t_factor;
  double start = 0;
  if (!(moved.error.direction <= 0x1p-12 && moved.error.origin <= frame.reach)) return FilterRay::Fate::unfiltered;
  if (!move_near(moved, frame, start)) return FilterRay::Fate::misses;
  // What is off by much is not moved near enough.
  if (!(plumb::largest(moved.origin) <= 4 * frame.reach)) return FilterRay::Fate::unfiltered;
  filter.t_start = start / filter.t_factor;
  if (!set_lines(filter, boxes, moved, frame)) return FilterRay::Fate::unfiltered;
  const double rounding = 0x1p-50 * std::fabs(start);
  // Nothing surely lies in it.
  filter.range = {wide_start(std::max(0.0, moved.t_min - rounding)), wide_end(moved.t_max + rounding),
                  std::numeric_limits<float>::infinity(), 0};
  return FilterRay::Fate::walk;
}

}  // namespace filter_ray

void set_filter_errors(FilterFrame& frame) {
  frame.near = frame.is_usable ? static_cast<float>(3.99 * frame.reach) : -1;
  frame.is_identity = frame.factor == 1 && frame.center == Point3{};
  FilterRay none;
  set_errors(none, frame, 0, 0, frame.margin, frame.distance_error);
  frame.weight_error = none.weight_error;
  frame.weight_error_constant = none.weight_error_constant;
}

}  // namespace plumb
