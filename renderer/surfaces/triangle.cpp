#include "renderer/surfaces/triangle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace plumb {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// By which side of each edge the ray passes.
enum class Side { misses, hits, unsure };

template <class Real>
Side side_of(const std::array<Real, 3>& weights, Real error) {
  const Real low = std::min(weights[0], std::min(weights[1], weights[2]));
  const Real high = std::max(weights[0], std::max(weights[1], weights[2]));
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

/// Of a t that is rounded once.
double rounding_error(double t) { return 0x1p-51 * std::fabs(t) + 0x1p-1070; }

/// Without rounding, in world space, up to the numbers at the end.
bool exactly_meet(const ShearedRay& sheared, const Point3& a, const Point3& b, const Point3& c,
                  TriangleMeeting& meeting) {
  const Ray& ray = sheared.world;
  if (!is_finite(ray.origin) || !is_finite(ray.direction) || !is_finite(a) || !is_finite(b) || !is_finite(c))
    return false;
  const ExactTriangle exact(ray, sheared.world_from_object, {a, b, c});
  if (!exact.is_met()) return false;
  const double t = exact.t();
  meeting = {t, rounding_error(t), exact.weight_b(), exact.weight_c(), 1, false};
  return std::isfinite(t);
}

/// Outside of these a product of three or four coordinates could leave the range of doubles, or be rounded below it.
bool is_ordinary(double size) { return size >= 0x1p-200 && size <= 0x1p200; }

/// The same in units in which the largest distance and the direction's largest coordinate lie in [1, 2). Powers of two
/// move numbers exactly, unless they fall below the smallest.
bool meet_in_its_own_units(const ShearedRay& sheared, double distance, const Point3& a, const Point3& b,
                           const Point3& c, TriangleMeeting& meeting) {
  const Ray& ray = sheared.ray;
  const double along = largest_coordinate(ray.direction);
  if (sheared.world_from_object) return exactly_meet(sheared, a, b, c, meeting);
  if (!(distance > 0 && along > 0 && std::isfinite(distance) && std::isfinite(along))) return false;
  const int points = -std::ilogb(distance), directions = -std::ilogb(along);
  bool exact = true;
  const auto scaled = [&](const auto& v, int exponent) {
    auto result = v;
    for (int axis = 0; axis < 3; ++axis) {
      result[axis] = std::scalbn(v[axis], exponent);
      exact = exact && std::scalbn(result[axis], -exponent) == v[axis];
    }
    return result;
  };
  const Ray unit{scaled(ray.origin, points), scaled(ray.direction, directions), -kInfinity};
  const Point3 unit_a = scaled(a, points), unit_b = scaled(b, points), unit_c = scaled(c, points);
  if (!exact) return exactly_meet(sheared, a, b, c, meeting);
  const ShearedRay unit_ray(unit);
  const ShearedTriangle unit_triangle(unit_ray, unit_a, unit_b, unit_c);
  if (!meet(unit_ray, unit_triangle, unit_a, unit_b, unit_c, meeting)) return false;
  meeting.t = std::scalbn(meeting.t, directions - points);
  meeting.t_error = std::scalbn(meeting.t_error, directions - points) + 0x1p-1070;
  return std::isfinite(meeting.t);
}

/// The plane of a triangle that is surely met, in 64 bits, where doubles have too few: the ray grazes it or starts in
/// it.
bool meet_closely(const ShearedRay& sheared, const std::array<double, 3>& weights, const Point3& a, const Point3& b,
                  const Point3& c, TriangleMeeting& meeting) {
  if (sheared.world_from_object) return exactly_meet(sheared, a, b, c, meeting);
  const Ray& ray = sheared.ray;
  const WideVector to_a = wide_difference(a, ray.origin);
  const WideVector edge_b = wide_difference(b, a), edge_c = wide_difference(c, a);
  const long double facing = triple(ray.direction, edge_b, edge_c);
  const long double distance = to_a[0] * (edge_b[1] * edge_c[2] - edge_b[2] * edge_c[1]) +
                               to_a[1] * (edge_b[2] * edge_c[0] - edge_b[0] * edge_c[2]) +
                               to_a[2] * (edge_b[0] * edge_c[1] - edge_b[1] * edge_c[0]);
  // Six terms, each with at most eight roundings of 2^-64 on its way: 48 2^-64 of the sizes' product.
  const long double size = static_cast<long double>(largest_coordinate(b - a)) * largest_coordinate(c - a);
  const long double facing_error = 0x1p-58L * size * std::fabs(coordinate(ray.direction, sheared.kz));
  const long double distance_error = 0x1p-58L * size * largest_coordinate(a - ray.origin);
  // So that t is as close as in doubles where these suffice: within 2^-41 of the way.
  const bool is_steep = std::fabs(facing) > 0x1p41L * facing_error;
  const bool starts_on_it = std::fabs(distance) < distance_error &&
                            !(std::fabs(distance) + distance_error < ray.t_min * (std::fabs(facing) - facing_error));
  if (!is_steep || starts_on_it) return exactly_meet(sheared, a, b, c, meeting);
  const long double t = distance / facing;
  const long double t_error = (distance_error + std::fabs(t) * facing_error) / std::fabs(facing);
  const auto rounded = static_cast<double>(t);
  meeting = {rounded,
             static_cast<double>(t_error) * (1 + 0x1p-30) + rounding_error(rounded),
             weights[1],
             weights[2],
             weights[0] + weights[1] + weights[2],
             false};
  return std::isfinite(rounded);
}

}  // namespace

bool meet(const ShearedRay& sheared, const ShearedTriangle& triangle, const Point3& a, const Point3& b, const Point3& c,
          TriangleMeeting& meeting) {
  const Ray& ray = sheared.ray;
  const double m = triangle.largest();
  if (!is_ordinary(m) || !is_ordinary(std::fabs(coordinate(ray.direction, sheared.kz)))) [[unlikely]]
    return meet_in_its_own_units(sheared, m, a, b, c, meeting);
  const auto& [pa, pb, pc] = triangle.plane;
  std::array<double, 3> weights = triangle.weights;
  const double reach =
      std::fabs(pa.x) + std::fabs(pa.y) + std::fabs(pb.x) + std::fabs(pb.y) + std::fabs(pc.x) + std::fabs(pc.y);
  const double error = weight_error(m, reach, sheared.drift, sheared.drift_growth);
  const bool is_placed = sheared.world_from_object != nullptr;
  if (!(error <= kLargest)) {  // NaN, or a direction without digits
    if (is_placed) return exactly_meet(sheared, a, b, c, meeting);
    return false;
  }
  Side side = side_of(weights, error);
  if (side == Side::unsure) {
    // The errors of a placed ray are those of doubles at least.
    if (is_placed) return exactly_meet(sheared, a, b, c, meeting);
    // Six terms of at most |d| m |edge|, each with six roundings on its way: 36 2^-64 of that.
    const double edge =
        std::max(largest_coordinate(b - a), std::max(largest_coordinate(c - b), largest_coordinate(a - c)));
    const auto wide = wide_weights(ray, a, b, c);
    side = side_of(wide, 0x1p-58L * std::fabs(coordinate(ray.direction, sheared.kz)) * m * edge);
    for (std::size_t i = 0; i < 3; ++i) weights[i] = static_cast<double>(wide[i]);
  }
  if (side == Side::misses) return false;
  if (side == Side::unsure) return exactly_meet(sheared, a, b, c, meeting);

  if (meet_plane(sheared, weights, a, b, c, kSteep, meeting)) return std::isfinite(meeting.t);
  return meet_closely(sheared, weights, a, b, c, meeting);
}

std::optional<double> exact_t_in_range(const ShearedRay& sheared, const TriangleMeeting& meeting, const Point3& a,
                                       const Point3& b, const Point3& c) {
  const Ray& ray = sheared.ray;
  if (!(ray.t_min <= ray.t_max)) return std::nullopt;  // NaN too
  const ExactTriangle exact(sheared.world, sheared.world_from_object, {a, b, c});
  if (exact.compare_t(ray.t_min) < 0 || exact.compare_t(ray.t_max) > 0) return std::nullopt;
  return std::clamp(meeting.t, ray.t_min, ray.t_max);
}

std::optional<TriangleHit> intersect_triangle(const ShearedRay& sheared, const Point3& a, const Point3& b,
                                              const Point3& c) {
  TriangleMeeting meeting;
  if (!meet(sheared, ShearedTriangle(sheared, a, b, c), a, b, c, meeting)) return std::nullopt;
  const auto t = t_in_range(sheared, meeting, a, b, c);
  if (!t) return std::nullopt;
  return meeting.hit(*t);
}

std::vector<Bounds3> triangle_bounds(const TriangleMesh& mesh) {
  std::vector<Bounds3> bounds(mesh.triangles.size());
  for (std::size_t i = 0; i < bounds.size(); ++i)
    for (const std::uint32_t vertex : mesh.triangles[i]) bounds[i].extend(mesh.positions[vertex]);
  return bounds;
}

}  // namespace plumb
