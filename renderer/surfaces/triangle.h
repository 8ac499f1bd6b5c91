#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <optional>
#include <vector>

#include "meshes/triangle_mesh.h"
#include "renderer/math/bounds3.h"
#include "renderer/math/placed_ray.h"
#include "renderer/surfaces/exact_triangle.h"

namespace plumb {

/// v[axis], read from its place in memory: no comparisons of the axis.
template <class Triple>
double coordinate(const Triple& v, int axis) {
  static_assert(sizeof(Triple) == 3 * sizeof(double));
  double value;
  std::memcpy(&value, reinterpret_cast<const std::byte*>(&v) + sizeof(double) * static_cast<std::size_t>(axis),
              sizeof value);
  return value;
}

template <class Triple>
double largest_coordinate(const Triple& v) {
  return std::max(std::fabs(v.x), std::max(std::fabs(v.y), std::fabs(v.z)));
}

/// The axis along which a direction is longest. Which that is cannot be guessed, so there is no branch.
inline int longest_axis(const Vec3& d) {
  const double x = std::fabs(d.x), y = std::fabs(d.y), z = std::fabs(d.z);
  // By which of x > y, x > z and y > z hold, as bits from the lowest.
  constexpr std::array<std::int8_t, 8> kLongest{2, 2, 2, 0, 1, 1, 1, 0};
  return kLongest[static_cast<std::size_t>(x > y) | static_cast<std::size_t>(x > z) << 1 |
                  static_cast<std::size_t>(y > z) << 2];
}

/// A ray with the shear that takes its direction to an axis: what does not depend on the triangle. It refers to the
/// ray, whose range may shrink meanwhile where it is in world space.
struct ShearedRay {
  explicit ShearedRay(const Ray& ray);
  explicit ShearedRay(const PlacedRay& placed);

  const Ray& ray;
  /// The exact ray, in world space, and the triangle's way there: as in PlacedRay.
  const Ray& world;
  const Transform* world_from_object = nullptr;
  double origin_error = 0, direction_error = 0;
  /// The axis along which the direction is longest, and the other two.
  int kx, ky, kz;
  double shear_x, shear_y;
  /// The origin's coordinates along these axes.
  double origin_x, origin_y, origin_z;
  /// A sheared coordinate of a vertex is off by this and by `drift_growth` of the vertex' distance, for the errors of
  /// the ray; zero in world space.
  double drift = 0, drift_growth = 0;

 private:
  void find_axes();
};

inline ShearedRay::ShearedRay(const Ray& of) : ray(of), world(of) { find_axes(); }

inline ShearedRay::ShearedRay(const PlacedRay& placed)
    : ray(placed.object()),
      world(*placed.world),
      world_from_object(placed.world_from_object),
      origin_error(placed.origin_error),
      direction_error(placed.direction_error) {
  find_axes();
  if (!world_from_object) return;
  // The shear is a quotient of at most 1, so it moves by less than 2 e / (|d_z| - e), with e the direction's error.
  const double along = std::fabs(coordinate(ray.direction, kz));
  drift = 2.5 * origin_error;
  drift_growth = direction_error <= 0x1p-12 * along ? 2.5 * direction_error / along : Bounds3::kInfinity;
}

inline void ShearedRay::find_axes() {
  const Vec3& d = ray.direction;
  kz = longest_axis(d);
  constexpr std::array<std::int8_t, 5> kCircle{0, 1, 2, 0, 1};
  kx = kCircle[static_cast<std::size_t>(kz) + 1];
  ky = kCircle[static_cast<std::size_t>(kz) + 2];
  const double along = coordinate(d, kz);
  shear_x = coordinate(d, kx) / along;
  shear_y = coordinate(d, ky) / along;
  origin_x = coordinate(ray.origin, kx);
  origin_y = coordinate(ray.origin, ky);
  origin_z = coordinate(ray.origin, kz);
}

/// A hit on one triangle: u and v are the weights of b and c.
struct TriangleHit {
  double t, u, v;
};

/// Where a ray's line meets a triangle, whatever the range.
struct TriangleMeeting {
  double t = 0;
  /// The exact t is not further from t than this.
  double t_error = 0;
  /// The weights of b and c, each times `sum`.
  double weight_b = 0, weight_c = 0, sum = 1;
  /// Whether t is not yet the one to report.
  bool is_rough = false;

  TriangleHit hit(double in_range) const { return {in_range, weight_b / sum, weight_c / sum}; }
};

/// Both sides count; edges and vertices belong to the triangle. A ray in the triangle's plane and a triangle without
/// area are missed, and so is every triangle by a ray with NaN.
///
/// The class is that of the ray and the triangle as given (in world space, placed by the exact matrix), and so is
/// whether t lies in the ray's closed range: no ray slips between neighbours, at a vertex neither. The reported t is
/// rounded; see TriangleMeeting. Bounds, ranges and sources: docs/certified-kernel.md.
std::optional<TriangleHit> intersect_triangle(const ShearedRay& sheared, const Point3& a, const Point3& b,
                                              const Point3& c);

/// A triangle seen along the ray: each vertex is a point of a plane [Woop 2013]. On which side of an edge the ray
/// passes is decided there, where the error bound allows.
struct ShearedTriangle {
  struct PlanePoint {
    double x, y;
  };

  ShearedTriangle(const ShearedRay& ray, const Point3& a, const Point3& b, const Point3& c)
      : from_origin{difference(ray, a), difference(ray, b), difference(ray, c)} {
    for (std::size_t i = 0; i < 3; ++i)
      plane[i] = {from_origin[i][0] - ray.shear_x * from_origin[i][2],
                  from_origin[i][1] - ray.shear_y * from_origin[i][2]};
    weights = {cross(plane[2], plane[1]), cross(plane[0], plane[2]), cross(plane[1], plane[0])};
  }

  /// Whether weights of different signs are both beyond `error`.
  bool is_missed(double error) const { return (lowest() < -error) & (highest() > error); }

  /// Whether all weights lie on one side of zero by more than `error`.
  bool is_sure_to_meet(double error) const { return (lowest() > error) | (highest() < -error); }

  /// The largest coordinate of a vertex from the origin.
  double largest() const {
    const auto of = [this](std::size_t i) {
      const auto& v = from_origin[i];
      return std::max(std::max(std::fabs(v[0]), std::fabs(v[1])), std::fabs(v[2]));
    };
    return std::max(std::max(of(0), of(1)), of(2));
  }

  /// The vertices from the ray's origin, in the order of its axes kx, ky, kz.
  std::array<std::array<double, 3>, 3> from_origin;
  std::array<PlanePoint, 3> plane;
  std::array<double, 3> weights;

 private:
  double lowest() const { return std::min(std::min(weights[0], weights[1]), weights[2]); }
  double highest() const { return std::max(std::max(weights[0], weights[1]), weights[2]); }
  static double cross(const PlanePoint& p, const PlanePoint& q) { return p.x * q.y - p.y * q.x; }

  static std::array<double, 3> difference(const ShearedRay& ray, const Point3& p) {
    return {coordinate(p, ray.kx) - ray.origin_x, coordinate(p, ray.ky) - ray.origin_y,
            coordinate(p, ray.kz) - ray.origin_z};
  }
};

/// The error of the weights where no vertex is further than `m` on an axis, and the six coordinates of the plane's
/// points sum up to `reach`; drift and its growth as of a ShearedRay. Derived in docs/certified-kernel.md.
inline double weight_error(double m, double reach, double drift, double drift_growth) {
  const double each = 0x1p-49 * m + (drift + drift_growth * m);
  return each * (reach + 2 * each);
}

/// The same whatever the plane's points are; infinity where no bound holds. A sheared coordinate is one of at most m
/// plus at most another such. For these m nothing overflows, and what underflows is below 2^-1074 m, far below the
/// bound.
inline double any_weight_error(double m, double drift, double drift_growth) {
  return m >= 0x1p-200 && m <= 0x1p200 ? weight_error(m, 12.1 * m, drift, drift_growth) : Bounds3::kInfinity;
}

/// How much of the edges' and the direction's sizes must be left in their product for a t that is reported, and for one
/// that only has to be told apart from others by its error.
constexpr double kSteep = 0x1p-6, kSteepEnough = 0x1p-24;

/// Where the ray's line meets the plane of a triangle, which it is known to meet with these weights; false where that
/// takes more digits: the ray grazes the plane, or starts in it, or the triangle is a needle. All numbers but t are
/// finite.
inline bool meet_plane(const ShearedRay& sheared, const std::array<double, 3>& weights, const Point3& a,
                       const Point3& b, const Point3& c, double least_slope, TriangleMeeting& meeting) {
  const Ray& ray = sheared.ray;
  const Vec3 to_a = a - ray.origin;
  const Vec3 edge_b = b - a;
  const Vec3 edge_c = c - a;
  const Vec3 normal = cross(edge_b, edge_c);
  const double facing = dot(normal, ray.direction);
  const double distance = dot(normal, to_a);
  // The normal is off by 8u of the edges' product. Where the plane is steep, the hit is then within some 2^-42 of the
  // way to it; elsewhere t has few digits left, nor a sign where the ray starts in the plane, unless t_min lies beyond.
  const double size = largest_coordinate(edge_b) * largest_coordinate(edge_c);
  const double along = std::fabs(coordinate(ray.direction, sheared.kz));
  // What underflows is far below the bounds, unless the edges are tiny.
  const double slope = std::fabs(facing), full_slope = size * along;
  const bool is_steep = size >= 0x1p-500 && slope > least_slope * full_slope;
  const double distance_error = 0x1p-47 * size * largest_coordinate(to_a) + 8 * size * sheared.origin_error;
  const bool starts_on_it =
      std::fabs(distance) < distance_error && !(std::fabs(distance) + distance_error < ray.t_min * std::fabs(facing));
  if (!is_steep || starts_on_it) return false;
  const double t = distance / facing;
  const double facing_error = 0x1p-47 * size * along + 8 * size * sheared.direction_error;
  // One by one: a copy would load pairs of numbers that were stored singly just before, which processors are slow at.
  meeting.t = t;
  meeting.t_error = (distance_error + std::fabs(t) * facing_error) * (1 / slope);
  meeting.is_rough = !(slope > kSteep * full_slope);
  meeting.weight_b = weights[1];
  meeting.weight_c = weights[2];
  meeting.sum = weights[0] + weights[1] + weights[2];
  return true;
}

/// Whether the ray's line meets the triangle that was sheared from a, b, c, exactly decided; if so, where.
bool meet(const ShearedRay& ray, const ShearedTriangle& sheared, const Point3& a, const Point3& b, const Point3& c,
          TriangleMeeting& meeting);

/// As t_in_range, where the rounded t is too near to a bound to tell.
std::optional<double> exact_t_in_range(const ShearedRay& ray, const TriangleMeeting& meeting, const Point3& a,
                                       const Point3& b, const Point3& c);

/// The t to report of a meeting whose exact t lies in the ray's closed range: nothing if it does not. Where the rounded
/// t lies outside, the bound.
inline std::optional<double> t_in_range(const ShearedRay& sheared, const TriangleMeeting& meeting, const Point3& a,
                                        const Point3& b, const Point3& c) {
  const Ray& ray = sheared.ray;
  const double low = meeting.t - meeting.t_error, high = meeting.t + meeting.t_error;
  if (low > ray.t_min && high < ray.t_max) return meeting.t;  // rounding is monotone, so these hold without it
  if (high < ray.t_min || low > ray.t_max) return std::nullopt;
  return exact_t_in_range(sheared, meeting, a, b, c);
}

/// The box of each triangle of a mesh, in its order.
std::vector<Bounds3> triangle_bounds(const TriangleMesh& mesh);

}  // namespace plumb
