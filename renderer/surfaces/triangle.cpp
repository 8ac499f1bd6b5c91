#include "renderer/surfaces/triangle.h"

#include <cmath>

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
  const PlanePoint pa = seen_along(sheared, to_a);
  const PlanePoint pb = seen_along(sheared, b - ray.origin);
  const PlanePoint pc = seen_along(sheared, c - ray.origin);
  const double weight_a = cross_with_exact_sign(pc, pb);
  const double weight_b = cross_with_exact_sign(pa, pc);
  const double weight_c = cross_with_exact_sign(pb, pa);
  const bool some_negative = weight_a < 0 || weight_b < 0 || weight_c < 0;
  const bool some_positive = weight_a > 0 || weight_b > 0 || weight_c > 0;
  if (some_negative == some_positive) return std::nullopt;  // on different sides, or all zero

  const Vec3 normal = cross(b - a, c - a);
  const double t = dot(normal, to_a) / dot(normal, ray.direction);
  if (!ray.contains(t) || !std::isfinite(t)) return std::nullopt;
  const double sum = weight_a + weight_b + weight_c;
  return TriangleHit{t, weight_b / sum, weight_c / sum};
}

std::vector<Bounds3> triangle_bounds(const TriangleMesh& mesh) {
  std::vector<Bounds3> bounds(mesh.triangles.size());
  for (std::size_t i = 0; i < bounds.size(); ++i)
    for (const std::uint32_t vertex : mesh.triangles[i]) bounds[i].extend(mesh.positions[vertex]);
  return bounds;
}

}  // namespace plumb
