#pragma once

#include <optional>
#include <vector>

#include "meshes/triangle_mesh.h"
#include "renderer/math/bounds3.h"
#include "renderer/math/ray.h"

namespace plumb {

/// A ray with the shear that takes its direction to an axis: what does not depend on the triangle. It refers to the
/// ray, whose range may shrink meanwhile.
struct ShearedRay {
  explicit ShearedRay(const Ray& ray);

  const Ray& ray;
  /// The axis along which the direction is longest, and the other two.
  int kx, ky, kz;
  double shear_x, shear_y;
};

/// A hit on one triangle: u and v are the weights of b and c.
struct TriangleHit {
  double t, u, v;
};

/// Both sides count; edges and vertices belong to the triangle. A ray in the triangle's plane and a triangle without
/// area are missed, and so is every triangle by a ray with NaN.
///
/// The class is that of the ray and the triangle as given, so no ray slips between neighbours, at a vertex neither.
/// Seen along the ray, each vertex is a point of a plane [Woop 2013]; on which side of an edge the ray passes is
/// decided there, where the error bound allows, and else without rounding. t is taken from the triangle's own plane,
/// with its edges as differences, which is more accurate than the same products; without rounding where the ray grazes
/// that plane, or the triangle is a needle, or the ray starts in it. The exact part wants every number to be zero or
/// within [2^-250, 2^250].
std::optional<TriangleHit> intersect_triangle(const ShearedRay& sheared, const Point3& a, const Point3& b,
                                              const Point3& c);

/// The box of each triangle of a mesh, in its order.
std::vector<Bounds3> triangle_bounds(const TriangleMesh& mesh);

}  // namespace plumb
