#pragma once

#include <optional>

#include "renderer/math/ray.h"

namespace plumb::bench {

/// The textbook form [Moller 1997], culling nothing; wrong where rounding makes it so.
struct PlainTest {
  explicit PlainTest(const Ray& asked) : ray(asked) {}
  std::optional<double> operator()(const Point3& a, const Point3& b, const Point3& c) const {
    const Vec3 e1 = b - a, e2 = c - a, s = ray.origin - a;
    const Vec3 p = cross(ray.direction, e2);
    const double det = dot(e1, p);
    if (det == 0) return std::nullopt;
    const double inverse = 1 / det, u = inverse * dot(s, p);
    if (!(u >= 0 && u <= 1)) return std::nullopt;
    const Vec3 q = cross(s, e1);
    const double v = inverse * dot(ray.direction, q);
    if (!(v >= 0 && u + v <= 1)) return std::nullopt;
    const double t = inverse * dot(e2, q);
    if (!ray.contains(t)) return std::nullopt;
    return t;
  }
  const Ray& ray;
};

}  // namespace plumb::bench
