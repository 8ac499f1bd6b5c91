#include "renderer/surfaces/triangle.h"

namespace plumb {

std::optional<TriangleHit> intersect_triangle(const Ray& ray, const Point3& a, const Point3& b, const Point3& c) {
  const Vec3 to_a = a - ray.origin;
  const Vec3 to_b = b - ray.origin;
  const Vec3 to_c = c - ray.origin;
  const double weight_a = dot(ray.direction, cross(to_c, to_b));
  const double weight_b = dot(ray.direction, cross(to_a, to_c));
  const double weight_c = dot(ray.direction, cross(to_b, to_a));
  const bool some_negative = weight_a < 0 || weight_b < 0 || weight_c < 0;
  const bool some_positive = weight_a > 0 || weight_b > 0 || weight_c > 0;
  if (some_negative == some_positive) return std::nullopt;  // on different sides, or all zero

  const Vec3 normal = cross(b - a, c - a);
  const double t = dot(normal, to_a) / dot(normal, ray.direction);
  if (!ray.contains(t)) return std::nullopt;
  const double sum = weight_a + weight_b + weight_c;
  return TriangleHit{t, weight_b / sum, weight_c / sum};
}

}  // namespace plumb
