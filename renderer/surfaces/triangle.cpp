#include "renderer/surfaces/triangle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "renderer/math/exact_sum.h"

namespace plumb {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();

struct PlanePoint {
  double x, y;
};

double cross(const PlanePoint& p, const PlanePoint& q) { return p.x * q.y - p.y * q.x; }

double largest(const Vec3& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

PlanePoint seen_along(const ShearedRay& s, const Vec3& v) {
  return {v[s.kx] - s.shear_x * v[s.kz], v[s.ky] - s.shear_y * v[s.kz]};
}

/// By which side of each edge the ray passes.
enum class Side { misses, hits, unsure };

template <class Real>
Side side_of(const std::array<Real, 3>& weights, Real error) {
  const auto [low, high] = std::minmax({weights[0], weights[1], weights[2]});
  if (low < -error && high > error) return Side::misses;
  return low > error || high < -error ? Side::hits : Side::unsure;
}

using WideVector = std::array<long double, 3>;

WideVector wide_difference(const Point3& a, const Point3& b) {
  return {static_cast<long double>(a.x) - b.x, static_cast<long double>(a.y) - b.y,
          static_cast<long double>(a.z) - b.z};
}

/// d . (p x q)
long double triple(const Vec3& d, const WideVector& p, const WideVector& q) {
  return d.x * (p[1] * q[2] - p[2] * q[1]) + d.y * (p[2] * q[0] - p[0] * q[2]) + d.z * (p[0] * q[1] - p[1] * q[0]);
}

/// The weights in 64 bits, each as the triple product of the direction, a vertex and the edge from there: 2^11 closer
/// to the edge than the sheared points.
std::array<long double, 3> wide_weights(const Ray& ray, const Point3& a, const Point3& b, const Point3& c) {
  return {triple(ray.direction, wide_difference(c, ray.origin), wide_difference(b, c)),
          triple(ray.direction, wide_difference(a, ray.origin), wide_difference(c, a)),
          triple(ray.direction, wide_difference(b, ray.origin), wide_difference(a, b))};
}

using ExactVector = std::array<ExactSum, 3>;

ExactVector exact_difference(const Point3& a, const Point3& b) {
  return {ExactSum(a.x) - b.x, ExactSum(a.y) - b.y, ExactSum(a.z) - b.z};
}

ExactVector cross(const ExactVector& p, const ExactVector& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

ExactSum dot(const ExactVector& p, const ExactVector& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }

/// The hit without rounding, up to its numbers at the end: the weights are triple products with the direction, which
/// are those of the sheared points times direction[kz].
std::optional<TriangleHit> exactly_intersect(const Ray& ray, const Point3& a, const Point3& b, const Point3& c) {
  const ExactVector to_a = exact_difference(a, ray.origin);
  const ExactVector to_b = exact_difference(b, ray.origin);
  const ExactVector to_c = exact_difference(c, ray.origin);
  const ExactVector direction{ray.direction.x, ray.direction.y, ray.direction.z};
  const ExactVector c_cross_b = cross(to_c, to_b);
  const ExactSum weights[] = {dot(direction, c_cross_b), dot(direction, cross(to_a, to_c)),
                              dot(direction, cross(to_b, to_a))};
  const auto [low, high] = std::minmax({weights[0].sign(), weights[1].sign(), weights[2].sign()});
  if (low == -high) return std::nullopt;  // on different sides, or all zero
  const long double sum = (weights[0] + weights[1] + weights[2]).rounded();
  const TriangleHit hit{static_cast<double>(dot(to_a, c_cross_b).rounded() / sum),
                        static_cast<double>(weights[1].rounded() / sum),
                        static_cast<double>(weights[2].rounded() / sum)};
  if (!ray.contains(hit.t) || !std::isfinite(hit.t)) return std::nullopt;
  return hit;
}

/// Outside of these a product of three or four coordinates could leave the range of doubles, or be rounded below it.
bool is_ordinary(double size) { return size >= 0x1p-200 && size <= 0x1p200; }

/// The same in units in which the largest distance and the direction's largest coordinate lie in [1, 2). Powers of two
/// move numbers exactly.
std::optional<TriangleHit> intersect_in_its_own_units(const Ray& ray, double distance, const Point3& a, const Point3& b,
                                                      const Point3& c) {
  const double along = largest(ray.direction);
  if (!(distance > 0 && along > 0 && std::isfinite(distance) && std::isfinite(along))) return std::nullopt;
  const int points = -std::ilogb(distance), directions = -std::ilogb(along);
  const auto scaled = [](auto v, int exponent) {
    for (int axis = 0; axis < 3; ++axis) v[axis] = std::scalbn(v[axis], exponent);
    return v;
  };
  const Ray unit{scaled(ray.origin, points), scaled(ray.direction, directions),
                 -std::numeric_limits<double>::infinity()};
  auto hit = intersect_triangle(ShearedRay(unit), scaled(a, points), scaled(b, points), scaled(c, points));
  if (!hit) return std::nullopt;
  hit->t = std::scalbn(hit->t, directions - points);
  if (!ray.contains(hit->t) || !std::isfinite(hit->t)) return std::nullopt;
  return hit;
}

}  // namespace

ShearedRay::ShearedRay(const Ray& of) : ray(of) {
  const Vec3 size{std::fabs(of.direction.x), std::fabs(of.direction.y), std::fabs(of.direction.z)};
  kz = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  kx = (kz + 1) % 3;
  ky = (kz + 2) % 3;
  shear_x = of.direction[kx] / of.direction[kz];
  shear_y = of.direction[ky] / of.direction[kz];
}

std::optional<TriangleHit> intersect_triangle(const ShearedRay& sheared, const Point3& a, const Point3& b,
                                              const Point3& c) {
  const Ray& ray = sheared.ray;
  const Vec3 to_a = a - ray.origin;
  const Vec3 to_b = b - ray.origin;
  const Vec3 to_c = c - ray.origin;
  const double m = std::max({largest(to_a), largest(to_b), largest(to_c)});
  if (!is_ordinary(m) || !is_ordinary(largest(ray.direction))) [[unlikely]]
    return intersect_in_its_own_units(ray, m, a, b, c);
  const PlanePoint pa = seen_along(sheared, to_a);
  const PlanePoint pb = seen_along(sheared, to_b);
  const PlanePoint pc = seen_along(sheared, to_c);
  std::array<double, 3> weights{cross(pc, pb), cross(pa, pc), cross(pb, pa)};

  // With m the largest coordinate from the origin, a sheared one is off by 6u m: u m by its difference, 3u m by that of
  // z, the shear and their product, 2u m by the sum of both, as |shear| <= 1. So a weight is off by 6u m times its four
  // coordinates, 4u m times them for its own roundings, and 72 (u m)^2.
  const double reach =
      std::fabs(pa.x) + std::fabs(pa.y) + std::fabs(pb.x) + std::fabs(pb.y) + std::fabs(pc.x) + std::fabs(pc.y);
  const double error = 0x1p-49 * m * (reach + 0x1p-48 * m);
  if (!(error <= kLargest)) return std::nullopt;  // NaN
  Side side = side_of(weights, error);
  if (side == Side::unsure) {
    // Six terms of at most |d| m |edge|, each with six roundings on its way: 36 2^-64 of that.
    const double edge = std::max({largest(b - a), largest(c - b), largest(a - c)});
    const auto wide = wide_weights(ray, a, b, c);
    side = side_of(wide, 0x1p-58L * largest(ray.direction) * m * edge);
    for (std::size_t i = 0; i < 3; ++i) weights[i] = static_cast<double>(wide[i]);
  }
  if (side == Side::misses) return std::nullopt;
  if (side == Side::unsure) return exactly_intersect(ray, a, b, c);

  const Vec3 edge_b = b - a;
  const Vec3 edge_c = c - a;
  const Vec3 normal = cross(edge_b, edge_c);
  const double facing = dot(normal, ray.direction);
  const double distance = dot(normal, to_a);
  // The normal is off by 8u of the edges' product. Where the plane is steep, the hit is then within some 2^-42 of the
  // way to it; elsewhere t has no digits left, nor a sign where the ray starts in the plane, unless t_min lies beyond.
  const double size = largest(edge_b) * largest(edge_c);
  const bool is_steep = std::fabs(facing) > 0x1p-6 * size * largest(ray.direction);
  const double distance_error = 0x1p-47 * size * largest(to_a);
  const bool starts_on_it =
      std::fabs(distance) < distance_error && !(std::fabs(distance) + distance_error < ray.t_min * std::fabs(facing));
  if (!is_steep || starts_on_it) return exactly_intersect(ray, a, b, c);

  const double t = distance / facing;
  if (!ray.contains(t) || !std::isfinite(t)) return std::nullopt;
  const double sum = weights[0] + weights[1] + weights[2];
  return TriangleHit{t, weights[1] / sum, weights[2] / sum};
}

std::vector<Bounds3> triangle_bounds(const TriangleMesh& mesh) {
  std::vector<Bounds3> bounds(mesh.triangles.size());
  for (std::size_t i = 0; i < bounds.size(); ++i)
    for (const std::uint32_t vertex : mesh.triangles[i]) bounds[i].extend(mesh.positions[vertex]);
  return bounds;
}

}  // namespace plumb
