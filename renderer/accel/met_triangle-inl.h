// The numbers of a hit that floats are sure of, three coordinates in a register; included once a target.
#if defined(PLUMB_RENDERER_ACCEL_MET_TRIANGLE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_RENDERER_ACCEL_MET_TRIANGLE_INL_H
#undef PLUMB_RENDERER_ACCEL_MET_TRIANGLE_INL_H
#else
#define PLUMB_RENDERER_ACCEL_MET_TRIANGLE_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "renderer/accel/float4.h"
#include "renderer/surfaces/surface.h"
#include "renderer/surfaces/triangle.h"

HWY_BEFORE_NAMESPACE();
namespace plumb {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR && HWY_MAX_BYTES >= 32

/// x, y, z and something else.
using Triple = double __attribute__((vector_size(32)));
/// Two numbers.
using Pair = double __attribute__((vector_size(16)));

using Wide = hn::FixedTag<double, 4>;

HWY_INLINE Triple all(double value) { return Triple{value, value, value, value}; }
template <class XYZ>
HWY_INLINE Triple triple(const XYZ& v) {
  return Triple{v.x, v.y, v.z, 0};
}
/// By Highway: of __builtin_convertvector GCC 12 makes two halves that are put together again.
HWY_INLINE Triple triple(BoxSide v) { return hn::PromoteTo(Wide(), hn::Vec<hn::FixedTag<float, 4>>{v}).raw; }
HWY_INLINE Triple yzx(Triple v) { return __builtin_shufflevector(v, v, 1, 2, 0, 3); }
HWY_INLINE Triple zxy(Triple v) { return __builtin_shufflevector(v, v, 2, 0, 1, 3); }
HWY_INLINE Triple cross(Triple p, Triple q) { return yzx(p) * zxy(q) - zxy(p) * yzx(q); }
/// The sums of both, each rounded as dot() of vec3.h.
HWY_INLINE Pair sums(Triple p, Triple q) {
  const Triple xz = __builtin_shufflevector(p, q, 0, 4, 2, 6);
  const Pair x = __builtin_shufflevector(xz, xz, 0, 1), y = __builtin_shufflevector(p, q, 1, 5),
             z = __builtin_shufflevector(xz, xz, 2, 3);
  return x + y + z;
}
HWY_INLINE Triple size_of(Triple v) {
  using Bits = std::int64_t __attribute__((vector_size(32)));
  return reinterpret_cast<Triple>(reinterpret_cast<Bits>(v) & INT64_MAX);
}
/// Whether no coordinate is larger.
HWY_INLINE bool are_within(Triple v, double size) {
  return hn::AllFalse(Wide(), hn::Gt(hn::Vec<Wide>{size_of(v)}, hn::Set(Wide(), size)));
}
HWY_INLINE double largest(Triple v) {
  const Triple sizes = size_of(v);
  return std::max(std::max(sizes[0], sizes[1]), sizes[2]);
}

/// As meet() and t_in_range() of a triangle that the ray is known to meet, to the bit, where doubles tell so easily;
/// false, and nothing is said, elsewhere. The corners are Point3 or, in floats, BoxSide. `axis` holds those of a
/// ShearedRay, unless rounding the direction to floats made two coordinates equally long. No weight is off by more than
/// `error`. The direction is of moderate size.
template <class Corner>
HWY_INLINE bool met_plainly(const PlacedRay& placed, const LaneMask& axis, double error,
                            const std::array<Corner, 3>& corners, SurfaceHit& hit) {
  const Ray& ray = placed.object();
  const Triple a = triple(corners[0]), b = triple(corners[1]), c = triple(corners[2]);
  const Triple o = triple(ray.origin), direction = triple(ray.direction);
  const auto kx = static_cast<std::size_t>(axis[0]), ky = static_cast<std::size_t>(axis[1]),
             kz = static_cast<std::size_t>(axis[2]);
  const double along = coordinate(ray.direction, axis[2]), length = std::fabs(along);
  const Triple shear = direction / all(along);
  const bool is_longest = are_within(direction, length);

  // As in ShearedTriangle: the plane's coordinates are the two other ones, and a weight is what is left of a cross
  // product.
  const Triple to_a = a - o, to_b = b - o, to_c = c - o;
  const std::array<Triple, 3> plane{to_a - shear * all(to_a[kz]), to_b - shear * all(to_b[kz]),
                                    to_c - shear * all(to_c[kz])};
  const auto weight = [&](std::size_t p, std::size_t q) {
    return plane[p][kx] * plane[q][ky] - plane[p][ky] * plane[q][kx];
  };
  const double u = weight(2, 1), v = weight(0, 2), w = weight(1, 0);
  const double lowest = std::min(std::min(u, v), w), highest = std::max(std::max(u, v), w);
  const bool is_inside = (lowest > error) | (highest < -error);

  // As meet_plane().
  const Triple edge_b = b - a, edge_c = c - a;
  const Triple normal = cross(edge_b, edge_c);
  const Pair both = sums(normal * direction, normal * to_a);
  const double facing = both[0], distance = both[1];
  const double size = largest(edge_b) * largest(edge_c);
  const double slope = std::fabs(facing);
  const bool is_steep = (size >= 0x1p-500) & (slope > kSteep * (size * length));
  const double distance_error = 0x1p-47 * size * largest(to_a) + 8 * size * placed.origin_error;
  const bool starts_on_it = std::fabs(distance) < distance_error;
  const double t = distance / facing;
  const double facing_error = 0x1p-47 * size * length + 8 * size * placed.direction_error;
  const double t_error = (distance_error + std::fabs(t) * facing_error) * (1 / slope);
  const bool is_in_range = (t - t_error > ray.t_min) & (t + t_error < ray.t_max);
  if (!(is_longest & is_inside & is_steep & !starts_on_it & is_in_range)) return false;
  const double det = u + v + w;
  hit.t = t;
  hit.u = v / det;
  hit.v = w / det;
  hit.t_error = t_error;
  return true;
}

#else  // a ClosestTriangle is as fast

template <class Corner>
HWY_INLINE bool met_plainly(const PlacedRay&, const LaneMask&, double, const std::array<Corner, 3>&, SurfaceHit&) {
  return false;
}

#endif

}  // namespace HWY_NAMESPACE
}  // namespace plumb
HWY_AFTER_NAMESPACE();

#endif
