#pragma once

#include "tools/kernels/triangle.h"

namespace plumb::kernels {

/// The test of [Moller 1997], without culling and without a smallest determinant, as it stands in most programs. The
/// edges belong to the triangle as far as roundings allow, which promises nothing.
template <class Real>
struct MollerTrumbore : Triangle<MollerTrumbore<Real>, Real> {
  using PreparedRay = RealRay<Real>;

  template <class Report>
  void intersect(const PreparedRay& ray, Report&& report) const {
    const Triple<Real> edge1 = this->corners[1] - this->corners[0];
    const Triple<Real> edge2 = this->corners[2] - this->corners[0];
    const Triple<Real> p = cross(ray.direction, edge2);
    const Real determinant = dot(edge1, p);
    if (determinant == 0) return;
    const Real inverse = 1 / determinant;
    const Triple<Real> s = ray.origin - this->corners[0];
    const Real u = dot(s, p) * inverse;
    if (!(u >= 0 && u <= 1)) return;
    const Triple<Real> q = cross(s, edge1);
    const Real v = dot(ray.direction, q) * inverse;
    if (!(v >= 0 && u + v <= 1)) return;
    const Real t = dot(edge2, q) * inverse;
    if (ray.contains(t)) report(t, u, v);
  }
};

/// What the kernels of this test declare.
constexpr plumb_contract moller_trumbore_contract(plumb_precision precision) {
  return {.precision = static_cast<std::uint32_t>(precision),
          .t_precision = static_cast<std::uint32_t>(precision),
          .culling = PLUMB_CULL_NONE,
          .edge_rule = PLUMB_EDGE_NONE,
          .range = PLUMB_RANGE_CLOSED,
          .inside = PLUMB_INSIDE_HITS_EXIT,
          .shapes = PLUMB_MESHES,
          .capabilities = PLUMB_THREAD_SAFE,
          .largest = 0};
}

}  // namespace plumb::kernels
