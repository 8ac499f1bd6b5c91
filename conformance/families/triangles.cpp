#include "conformance/families/triangles.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace plumb {
namespace {

double longest_edge(const Vertices& t) {
  return std::max({length(t[1] - t[0]), length(t[2] - t[1]), length(t[0] - t[2])});
}

/// Scaled so that no product of its coordinates over- or underflows.
Vec3 direction_of(const Vec3& v) { return normalized(v / largest(v)); }

}  // namespace

Vertices ordinary_triangle(Random& random, const Rounding& rounded, const Point3& center, double size) {
  while (true) {
    Vertices shape;
    for (Point3& p : shape) p = random_point(random, -1, 1);
    const double edge = longest_edge(shape);
    if (edge < 0.7 || length(normal_of(shape)) < 0.4 * edge * edge) continue;
    for (Point3& p : shape) p = rounded(center + size * from_zero(p));
    return shape;
  }
}

Vec3 normal_of(const Vertices& t) { return cross(t[1] - t[0], t[2] - t[0]); }

Point3 middle_of(const Vertices& t) { return weighted(t, 1.0 / 3, 1.0 / 3); }

Point3 weighted(const Vertices& t, double v, double w) { return t[0] + (v * (t[1] - t[0]) + w * (t[2] - t[0])); }

Point3 inner_point(Random& random, const Vertices& triangle) {
  while (true) {
    const double v = random.between(0.05, 0.9);
    const double w = random.between(0.05, 0.9);
    if (v + w <= 0.95) return weighted(triangle, v, w);
  }
}

Point3 outer_point(Random& random, const Vertices& triangle) {
  while (true) {
    const double v = random.between(-2, 3);
    const double w = random.between(-2, 3);
    const double least = std::min({v, w, 1 - v - w});
    if (least >= -2 && least <= -0.05) return weighted(triangle, v, w);
  }
}

Point3 edge_point(Random& random, const Vertices& triangle) {
  const std::size_t from = random.below(3);
  return triangle[from] + random.unit() * (triangle[(from + 1) % 3] - triangle[from]);
}

Point3 any_point(Random& random, const Vertices& triangle) {
  switch (random.below(8)) {
    case 0:
    case 1:
      return inner_point(random, triangle);
    case 2:
    case 3:
      return outer_point(random, triangle);
    case 4:
      return triangle[random.below(3)];
    default:
      return edge_point(random, triangle);
  }
}

Point3 facing_origin(Random& random, const Vertices& triangle, double size, const Rounding& rounded) {
  // A normal of edges that are scaled first, for triangles whose normal would underflow.
  const Vec3 a = triangle[1] - triangle[0];
  const Vec3 b = triangle[2] - triangle[0];
  const Vec3 n = direction_of(cross(a / largest(a), b / largest(b)));
  while (true) {
    const Vec3 way = random_direction(random);
    if (std::fabs(dot(way, n)) < 0.5) continue;
    return rounded(middle_of(triangle) + size * random.between(1.5, 4) * way);
  }
}

double triangle_condition(const Vertices& triangle, const std::vector<Ray>& rays, const Rounding& rounded) {
  const double edge = std::max(
      {largest(triangle[1] - triangle[0]), largest(triangle[2] - triangle[1]), largest(triangle[0] - triangle[2])});
  const Vec3 a = (triangle[1] - triangle[0]) / edge;
  const Vec3 b = (triangle[2] - triangle[0]) / edge;
  const Vec3 n = cross(a, b);
  const double edges = std::max({dot(a, a), dot(b, b), dot(b - a, b - a)});
  double least = 1;
  for (const Ray& ray : rays) {
    const Vec3 d = direction_of(ray.direction);
    Vec3 s = triangle[0] - ray.origin;
    if (s == Vec3{}) s = triangle[1] - ray.origin;
    least = std::min({least, std::fabs(dot(d, n)) / edges, std::fabs(dot(direction_of(s), n)) / edges});
  }
  return std::clamp(1 / least, 1.0, rounded.largest_condition());
}

FamilyCase triangle_case(const Vertices& triangle, std::vector<Ray> rays, double condition) {
  Shape shape;
  shape.kind = ShapeKind::triangle;
  shape.vertices = triangle;
  return case_of(std::move(shape), std::move(rays), condition);
}

FamilyCase triangle_case(const Vertices& triangle, std::vector<Ray> rays, const Rounding& rounded) {
  const double condition = triangle_condition(triangle, rays, rounded);
  return triangle_case(triangle, std::move(rays), condition);
}

}  // namespace plumb
