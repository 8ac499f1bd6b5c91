// The numbers of a hit that floats are sure of, three coordinates in a register; included once a target.
#if defined(PLUMB_RENDERER_ACCEL_MET_TRIANGLE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_RENDERER_ACCEL_MET_TRIANGLE_INL_H
#undef PLUMB_RENDERER_ACCEL_MET_TRIANGLE_INL_H
#else
#define PLUMB_RENDERER_ACCEL_MET_TRIANGLE_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "renderer/surfaces/surface.h"
#include "renderer/surfaces/triangle.h"

HWY_BEFORE_NAMESPACE();
namespace plumb {
namespace HWY_NAMESPACE {

#if HWY_TARGET != HWY_SCALAR && HWY_MAX_BYTES >= 32

/// x, y, z and something else.
using Triple = double __attribute__((vector_size(32)));

HWY_INLINE Triple all(double value) { return Triple{value, value, value, value}; }
template <class XYZ>
HWY_INLINE Triple triple(const XYZ& v) {
  return Triple{v.x, v.y, v.z, 0};
}
HWY_INLINE Triple yzx(Triple v) { return __builtin_shufflevector(v, v, 1, 2, 0, 3); }
HWY_INLINE Triple zxy(Triple v) { return __builtin_shufflevector(v, v, 2, 0, 1, 3); }
HWY_INLINE Triple cross(Triple p, Triple q) { return yzx(p) * zxy(q) - zxy(p) * yzx(q); }
/// Rounded as dot() of vec3.h.
HWY_INLINE double sum(Triple v) { return (v + yzx(v) + zxy(v))[0]; }
HWY_INLINE Triple size_of(Triple v) {
  using Bits = std::int64_t __attribute__((vector_size(32)));
  return reinterpret_cast<Triple>(reinterpret_cast<Bits>(v) & INT64_MAX);
}
HWY_INLINE Triple higher_of(Triple p, Triple q) { return p > q ? p : q; }
HWY_INLINE double largest(Triple v) {
  const Triple sizes = size_of(v);
  return higher_of(higher_of(sizes, yzx(sizes)), zxy(sizes))[0];
}

/// As meet() and t_in_range() of a triangle that the ray is known to meet, to the bit, where doubles tell so easily;
/// false, and nothing is said, elsewhere. No coordinate of the mesh is larger than `largest_vertex`; those of the
/// direction are of moderate size.
template <class Corners>
HWY_INLINE bool met_plainly(const PlacedRay& placed, double largest_vertex, const Corners& corners, SurfaceHit& hit) {
  const Triple a = triple(corners[0]), b = triple(corners[1]), c = triple(corners[2]);
  const Ray& ray = placed.object();
  const Triple o = triple(ray.origin), direction = triple(ray.direction);
  const auto longest = static_cast<std::size_t>(longest_axis(ray.direction));
  const double along = direction[longest], length = std::fabs(along);
  const Triple shear = direction / all(along);

  // As in ShearedTriangle: the plane's coordinates are the two other ones, and a weight is what is left of a cross
  // product.
  const Triple to_a = a - o, to_b = b - o, to_c = c - o;
  const Triple plane_a = to_a - shear * all(to_a[longest]), plane_b = to_b - shear * all(to_b[longest]),
               plane_c = to_c - shear * all(to_c[longest]);
  const double u = cross(plane_c, plane_b)[longest], v = cross(plane_a, plane_c)[longest],
               w = cross(plane_b, plane_a)[longest];
  const double m = 1.001 * (largest_vertex + largest(o));
  const double each = 0x1p-49 * m + (2.5 * placed.origin_error + 2.5 * placed.direction_error / length * m);
  const double error = each * (12.1 * m + 2 * each);
  const double lowest = std::min(std::min(u, v), w), highest = std::max(std::max(u, v), w);
  const bool is_ordinary = (m >= 0x1p-200) & (m <= 0x1p200);
  const bool is_inside = (lowest > error) | (highest < -error);

  // As meet_plane().
  const Triple edge_b = b - a, edge_c = c - a;
  const Triple normal = cross(edge_b, edge_c);
  const double facing = sum(normal * direction), distance = sum(normal * to_a);
  const double size = largest(edge_b) * largest(edge_c);
  const double slope = std::fabs(facing);
  const bool is_steep = (size >= 0x1p-500) & (slope > kSteep * (size * length));
  const double distance_error = 0x1p-47 * size * largest(to_a) + 8 * size * placed.origin_error;
  const bool starts_on_it = std::fabs(distance) < distance_error;
  const double t = distance / facing;
  const double facing_error = 0x1p-47 * size * length + 8 * size * placed.direction_error;
  const double t_error = (distance_error + std::fabs(t) * facing_error) * (1 / slope);
  const bool is_in_range = (t - t_error > ray.t_min) & (t + t_error < ray.t_max);
  if (!(is_ordinary & is_inside & is_steep & !starts_on_it & is_in_range)) return false;
  const double det = u + v + w;
  hit.t = t;
  hit.u = v / det;
  hit.v = w / det;
  hit.t_error = t_error;
  return true;
}

#else  // a ClosestTriangle is as fast

template <class Corners>
HWY_INLINE bool met_plainly(const PlacedRay&, double, const Corners&, SurfaceHit&) {
  return false;
}

#endif

}  // namespace HWY_NAMESPACE
}  // namespace plumb
HWY_AFTER_NAMESPACE();

#endif
