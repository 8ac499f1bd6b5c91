#include "renderer/math/placed_ray.h"

#include <algorithm>
#include <cmath>

namespace plumb {
namespace {

double largest(double x, double y, double z) { return std::max({std::fabs(x), std::fabs(y), std::fabs(z)}); }

}  // namespace

PlacedRay::PlacedRay(const Ray& world_ray, const Transform& transform) : world(&world_ray) {
  if (transform.is_identity()) return;
  object_ = transform.inverse_of(world_ray);
  world_from_object = &transform;
  const Point3& o = world_ray.origin;
  const Vec3& d = world_ray.direction;
  double origin_terms = 0, direction_terms = 0;
  for (const auto& row : transform.inverse_matrix()) {
    origin_terms = std::max(
        origin_terms, std::fabs(row[0] * o.x) + std::fabs(row[1] * o.y) + std::fabs(row[2] * o.z) + std::fabs(row[3]));
    direction_terms =
        std::max(direction_terms, std::fabs(row[0] * d.x) + std::fabs(row[1] * d.y) + std::fabs(row[2] * d.z));
  }
  // An entry of the inverse is off by 0.51 of its last place, which is 1.02 u of it, u = 2^-53; its product rounds by u
  // and so does each of up to three sums: 5.03 u of the terms' magnitudes. They are summed here with at most four
  // roundings, so 6 u of that is above it. Below the smallest normal number an entry, a product and a sum are off by
  // 2^-1074 at most each, the entry times a coordinate.
  const auto error = [](double terms, double size) { return 6 * 0x1p-53 * terms + 0x1p-1060 * (1 + size); };
  origin_error = error(origin_terms, largest(o.x, o.y, o.z));
  direction_error = error(direction_terms, largest(d.x, d.y, d.z));
}

double PlacedRay::drift(double reach) const {
  if (!world_from_object) return 0;
  const double along = largest(object_.direction.x, object_.direction.y, object_.direction.z);
  if (!(direction_error <= 0.5 * along)) return std::numeric_limits<double>::infinity();
  // At that t the exact ray is |t| |d| from its origin, which is at most reach + |o|, on the axis where its direction
  // is longest. Four times instead of twice, for the roundings here.
  const double way = reach + largest(object_.origin.x, object_.origin.y, object_.origin.z) + origin_error;
  return 2 * origin_error + 4 * direction_error * (way / along);
}

}  // namespace plumb
