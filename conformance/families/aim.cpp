#include "conformance/families/aim.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace plumb {

double largest(const Vec3& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

Vec3 random_direction(Random& random) {
  while (true) {
    const Vec3 v{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    const double square = dot(v, v);
    if (square <= 1 && square > 0x1p-20) return v / std::sqrt(square);
  }
}

Vec3 random_perpendicular(Random& random, const Vec3& axis) {
  while (true) {
    const Vec3 v = cross(axis / largest(axis), random_direction(random));
    if (dot(v, v) > 0x1p-6) return normalized(v);
  }
}

Vec3 random_in_plane(Random& random, int axis_a, int axis_b) {
  while (true) {
    Vec3 v;
    v[axis_a] = random.between(-1, 1);
    v[axis_b] = random.between(-1, 1);
    const double square = dot(v, v);
    if (square <= 1 && square > 0x1p-20) return v / std::sqrt(square);
  }
}

Point3 random_point(Random& random, double low, double high) {
  return {random.between(low, high), random.between(low, high), random.between(low, high)};
}

Ray ray_to(const Point3& origin, const Point3& target, const Rounding& rounded) {
  const Vec3 direction = rounded(target - origin);
  return {origin, direction == Vec3{} ? Vec3{0, 0, 1} : direction};
}

FamilyCase case_of(Shape shape, std::vector<Ray> rays, double condition) {
  FamilyCase result;
  result.surface.shape = std::move(shape);
  result.rays = std::move(rays);
  result.condition = condition;
  return result;
}

}  // namespace plumb
