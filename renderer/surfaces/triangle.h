#pragma once

#include <optional>

#include "renderer/math/ray.h"

namespace plumb {

/// A hit on one triangle: u and v are the weights of b and c.
struct TriangleHit {
  double t, u, v;
};

/// Both sides count; edges and vertices belong to the triangle. A ray in the triangle's plane and a triangle
/// without area are missed.
///
/// Which side of an edge the ray passes is the sign of d . (p x q) with p, q the edge's ends seen from the
/// origin. The neighbour computes exactly the negated number, so no ray slips between the two [Woop 2013].
/// t is taken from the plane, with the edges as differences, which is more accurate than the same products.
std::optional<TriangleHit> intersect_triangle(const Ray& ray, const Point3& a, const Point3& b, const Point3& c);

}  // namespace plumb
