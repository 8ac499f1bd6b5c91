#include "renderer/surfaces/triangle.h"

#include <algorithm>
#include <cmath>

#include "renderer/math/exact_sum.h"

namespace plumb {
namespace {

struct PlanePoint {
  double x, y;
};

/// p x q, with the exact sign of its value. Rounding is monotone, so two rounded products that differ, differ the same
/// way as the exact ones; where they are equal, the rounding errors, which fma gives exactly, decide. (Below 1e-290 the
/// errors themselves may underflow.)
double cross_with_exact_sign(const PlanePoint& p, const PlanePoint& q) {
  const double left = p.x * q.y;
  const double right = p.y * q.x;
  if (left != right) return left - right;
  return std::fma(p.x, q.y, -left) - std::fma(p.y, q.x, -right);
}

PlanePoint seen_along(const ShearedRay& s, const Vec3& v) {
  return {v[s.kx] - s.shear_x * v[s.kz], v[s.ky] - s.shear_y * v[s.kz]};
}

double largest(const Vec3& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

/// Whether t from the triangle's plane keeps the hit within some 2^-43 of the ray's way to the triangle: the errors of
/// the normal, of both dot products, are within 2^-48 of these sizes.
bool is_steep(const Vec3& edge_b, const Vec3& edge_c, const Vec3& direction, double normal_dot_direction) {
  return std::fabs(normal_dot_direction) > 0x1p-6 * largest(edge_b) * largest(edge_c) * largest(direction);
}

/// p x q without rounding.
ExactSum exact_cross(const PlanePoint& p, const PlanePoint& q) {
  return ExactSum().add_product(p.x, q.y).add_product(-p.y, q.x);
}

/// The hit by the exact weights of the points seen along the ray, t as the mean of the vertices' own: never beyond
/// them, where the plane's t may be anything.
TriangleHit interpolated_hit(const ShearedRay& s, const PlanePoint (&seen)[3], const Vec3 (&to_vertex)[3]) {
  long double weights[3];
  long double sum = 0, weighted = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    weights[i] = exact_cross(seen[(i + 2) % 3], seen[(i + 1) % 3]).rounded();
    sum += weights[i];
    weighted += weights[i] * to_vertex[i][s.kz];
  }
  return {static_cast<double>(weighted / sum / s.ray.direction[s.kz]), static_cast<double>(weights[1] / sum),
          static_cast<double>(weights[2] / sum)};
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
  const Vec3 to_vertex[] = {a - ray.origin, b - ray.origin, c - ray.origin};
  const PlanePoint seen[] = {seen_along(sheared, to_vertex[0]), seen_along(sheared, to_vertex[1]),
                             seen_along(sheared, to_vertex[2])};
  const double weight_a = cross_with_exact_sign(seen[2], seen[1]);
  const double weight_b = cross_with_exact_sign(seen[0], seen[2]);
  const double weight_c = cross_with_exact_sign(seen[1], seen[0]);
  const bool some_negative = weight_a < 0 || weight_b < 0 || weight_c < 0;
  const bool some_positive = weight_a > 0 || weight_b > 0 || weight_c > 0;
  if (some_negative == some_positive) return std::nullopt;  // on different sides, or all zero

  const Vec3 edge_b = b - a;
  const Vec3 edge_c = c - a;
  const Vec3 normal = cross(edge_b, edge_c);
  const double facing = dot(normal, ray.direction);
  const double sum = weight_a + weight_b + weight_c;
  const TriangleHit hit = is_steep(edge_b, edge_c, ray.direction, facing)
                              ? TriangleHit{dot(normal, to_vertex[0]) / facing, weight_b / sum, weight_c / sum}
                              : interpolated_hit(sheared, seen, to_vertex);
  if (!ray.contains(hit.t) || !std::isfinite(hit.t)) return std::nullopt;
  return hit;
}

std::vector<Bounds3> triangle_bounds(const TriangleMesh& mesh) {
  std::vector<Bounds3> bounds(mesh.triangles.size());
  for (std::size_t i = 0; i < bounds.size(); ++i)
    for (const std::uint32_t vertex : mesh.triangles[i]) bounds[i].extend(mesh.positions[vertex]);
  return bounds;
}

}  // namespace plumb
