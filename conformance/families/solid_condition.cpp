#include <algorithm>
#include <cmath>
#include <limits>

#include "conformance/families/solids.h"

namespace plumb {
namespace {

/// The first crossing so far, and its condition.
struct First {
  double t = std::numeric_limits<double>::infinity();
  double condition = 1;

  void offer(double at, double t_min, double amplified, double through) {
    if (!(at >= t_min && at < t)) return;
    t = at;
    condition = amplified / (at * std::fabs(through));
  }
};

double amplified(const Vec3& gradient, const Vec3& f) {
  return std::fabs(gradient.x * f.x) + std::fabs(gradient.y * f.y) + std::fabs(gradient.z * f.z);
}

/// The side x^2 + y^2 + bend z^2 = r^2 about f's zero: a sphere (1), a cylinder (0), or with r = 0 a cone (-slope^2).
/// The discriminant by way of the point of the line that is nearest in this metric, which cancels least.
void offer_side(First& first, const Vec3& f, const Vec3& d, double bend, double radius, double half_height,
                double middle_z, double t_min) {
  const auto product = [&](const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + bend * (a.z * b.z); };
  const double along = product(d, d);
  if (along == 0) return;
  const double b = product(f, d) / along;
  const Vec3 nearest = f - b * d;
  const double square = (radius * radius - product(nearest, nearest)) / along;
  if (!(square >= 0)) return;
  for (const double t : {-b - std::sqrt(square), -b + std::sqrt(square)}) {
    const Vec3 p = f + t * d;
    if (std::fabs(p.z - middle_z) > half_height) continue;
    const Vec3 gradient{p.x, p.y, bend * p.z};
    first.offer(t, t_min, amplified(gradient, f), dot(gradient, d));
  }
}

double ray_condition(const Shape& solid, const Ray& ray) {
  First first;
  const Vec3 d = ray.direction;
  const Vec3 f = ray.origin - solid.center;
  if (solid.kind == ShapeKind::sphere) {
    offer_side(first, f, d, 1, solid.radius, Bounds3::kInfinity, 0, ray.t_min);
    return first.condition;
  }
  const double half = 0.5 * solid.height;
  if (solid.kind == ShapeKind::cylinder) {
    offer_side(first, f, d, 0, solid.radius, half, 0, ray.t_min);
  } else {
    const double to_tip = solid.tip_z - solid.center.z;
    const double slope = solid.radius / to_tip;
    offer_side(first, f - Vec3{0, 0, to_tip}, d, -slope * slope, 0, half, -to_tip, ray.t_min);
  }
  for (const double z : {-half, half}) {
    if (d.z == 0) break;
    const double t = (z - f.z) / d.z;
    const Vec3 p = f + t * d;
    const double radius = radius_at(solid, solid.center.z + z);
    if (p.x * p.x + p.y * p.y > radius * radius) continue;
    first.offer(t, ray.t_min, std::max(std::fabs(f.z), half), d.z);
  }
  return first.condition;
}

}  // namespace

double solid_condition(const Shape& solid, const std::vector<Ray>& rays, const Rounding& rounded) {
  if (solid.kind == ShapeKind::box) return 1;
  double worst = 1;
  for (const Ray& ray : rays) {
    const double condition = ray_condition(solid, ray);
    // Where t is 0 it is infinite or NaN.
    worst = condition < rounded.largest_condition() ? std::max(worst, condition) : rounded.largest_condition();
    if (worst == rounded.largest_condition()) break;
  }
  return worst;
}

}  // namespace plumb
