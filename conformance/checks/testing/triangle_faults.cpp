#include <algorithm>
#include <array>
#include <cmath>

#include "conformance/checks/testing/planted_fault.h"
#include "renderer/math/bounds3.h"

namespace plumb::planted {
namespace {

using Vertices = std::array<Point3, 3>;

/// What the test of [Moller 1997] computes, before anything is compared.
template <class Real>
struct Terms {
  Terms(const Vertices& v, const Ray& ray) {
    const auto minus = [](const Point3& a, const Point3& b) {
      return Triple{Real(a.x) - Real(b.x), Real(a.y) - Real(b.y), Real(a.z) - Real(b.z)};
    };
    const Triple d{Real(ray.direction.x), Real(ray.direction.y), Real(ray.direction.z)};
    const Triple e1 = minus(v[1], v[0]), e2 = minus(v[2], v[0]), s = minus(ray.origin, v[0]);
    const Triple p = across(d, e2), q = across(s, e1);
    determinant = times(e1, p);
    u = times(s, p) / determinant;
    v_weight = times(d, q) / determinant;
    t = times(e2, q) / determinant;
  }

  bool inside() const { return u >= 0 && v_weight >= 0 && u + v_weight <= 1; }
  /// The least of the three weights.
  Real least() const { return std::min({u, v_weight, 1 - u - v_weight}); }

  Real determinant, u, v_weight, t;

 private:
  struct Triple {
    Real x, y, z;
  };
  static Real times(const Triple& a, const Triple& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
  static Triple across(const Triple& a, const Triple& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
};

/// A subject that tests every triangle by `accepts(terms, vertices, ray, t)`, which may move t.
template <class Real = double, class Accepts>
std::function<std::unique_ptr<Subject>()> triangles(Accepts accepts, plumb_precision precision = PLUMB_DOUBLE) {
  const auto one = [accepts](const Vertices& v, const Ray& ray, std::uint32_t index, std::vector<LocalHit>& hits) {
    const Terms<Real> terms(v, ray);
    double t = static_cast<double>(terms.t);
    if (accepts(terms, v, ray, t))
      hits.push_back({t, static_cast<double>(terms.u), static_cast<double>(terms.v_weight), index, {}});
  };
  const auto hits = [one](const Shape& shape, const Ray& ray) {
    std::vector<LocalHit> found;
    if (!shape.mesh) {
      one(shape.vertices, ray, 0, found);
      return found;
    }
    for (std::uint32_t i = 0; i < shape.mesh->triangles.size(); ++i) {
      const auto [a, b, c] = shape.mesh->triangles[i];
      const auto& p = shape.mesh->positions;
      one({p[a], p[b], p[c]}, ray, i, found);
    }
    return found;
  };
  return spoiled([hits, precision](Formulas& f) {
    f.contract.matrices = false;
    f.contract.shapes = PLUMB_MESHES;
    f.contract.precision = f.contract.t_precision = precision;
    f.hits = hits;
  });
}

using Double = Terms<double>;

/// Triangles whose weights must all pass `least`.
std::function<std::unique_ptr<Subject>()> inset(double least) {
  return triangles([least](const Double& m, const Vertices&, const Ray& ray, double& t) {
    return m.least() > least && ray.contains(t);
  });
}

std::function<std::unique_ptr<Subject>()> determinant_above(double least) {
  return triangles([least](const Double& m, const Vertices&, const Ray& ray, double& t) {
    return std::fabs(m.determinant) > least && m.inside() && ray.contains(t);
  });
}

/// n.o + w from the plane through the first vertex, in place of n.(a - o).
bool by_plane_equation(const Double& m, const Vertices& v, const Ray& ray, double& t) {
  const Vec3 n = cross(v[1] - v[0], v[2] - v[0]);
  const double w = dot(n, Vec3{v[0].x, v[0].y, v[0].z});
  t = (w - dot(n, Vec3{ray.origin.x, ray.origin.y, ray.origin.z})) / dot(n, ray.direction);
  return m.inside() && ray.contains(t);
}

/// The octant of the reciprocal direction from `d < 0`, which is false for -0 although 1 / -0 is -infinity.
bool in_box_by_octant(const Double& m, const Vertices& v, const Ray& ray, double& t) {
  Bounds3 box;
  for (const Point3& p : v) box.extend(p);
  double enter = ray.t_min, leave = ray.t_max;
  for (int axis = 0; axis < 3; ++axis) {
    const double inverse = 1 / ray.direction[axis];
    const bool backwards = ray.direction[axis] < 0;
    const double near = ((backwards ? box.max : box.min)[axis] - ray.origin[axis]) * inverse;
    const double far = ((backwards ? box.min : box.max)[axis] - ray.origin[axis]) * inverse;
    enter = std::fmax(enter, near);
    leave = std::fmin(leave, far);
  }
  return enter <= leave * (1 + 1e-9) && m.inside() && ray.contains(t);
}

}  // namespace

std::vector<Fault> triangle_faults() {
  const auto faces_the_ray = [](const Vertices& v, const Ray& ray) {
    return dot(cross(v[1] - v[0], v[2] - v[0]), ray.direction) < 0;
  };
  return {
      {"T0", "back faces culled, which the contract does not say", Verdict::fail, "class",
       triangles([=](const Double& m, const Vertices& v, const Ray& ray, double& t) {
         return faces_the_ray(v, ray) && m.inside() && ray.contains(t);
       })},
      {"T1", "weights above an epsilon of 1e-3", Verdict::fail, "boundary", inset(1e-3)},
      {"T2", "weights above an epsilon of 1e-3", Verdict::fail, "boundary", inset(1e-3)},
      {"T3", "strict comparisons, where neighbours share an edge", Verdict::fail, "escape", inset(0)},
      {"T4", "determinants up to 1e-6 count as parallel", Verdict::fail, "class", determinant_above(1e-6)},
      {"T5", "determinants up to 1e-8 count as parallel", Verdict::fail, "class", determinant_above(1e-8)},
      {"T6", "determinants up to 1e-8 count as parallel", Verdict::fail, "class", determinant_above(1e-8)},
      {"T7", "t by the plane's equation, which cancels far from zero", Verdict::fail, "t",
       triangles(by_plane_equation)},
      {"T8", "products in float overflow", Verdict::fail, "class",
       triangles<float>([](const Terms<float>& m, const Vertices&, const Ray& ray,
                           double& t) { return m.inside() && ray.contains(t) && std::isfinite(t); },
                        PLUMB_FLOAT)},
      {"T9", "the octant of -0 is that of +0", Verdict::fail, "class", triangles(in_box_by_octant)},
      {"T10", "hits before t = 1e-3 left out, where the range is said to be closed", Verdict::fail, "boundary",
       triangles([](const Double& m, const Vertices&, const Ray& ray, double& t) {
         return m.inside() && ray.contains(t) && t > 1e-3;
       })},
      {"T10", "the same face is met again, a unit behind", Verdict::fail, "t",
       triangles([](const Double& m, const Vertices&, const Ray& ray, double& t) {
         if (!m.inside() || !ray.contains(t)) return false;
         t += 1;
         return true;
       })},
      {"T11", "u < 0 || u > 1 is false for the NaN of 0 / 0", Verdict::fail, "not_finite",
       triangles([](const Double& m, const Vertices&, const Ray& ray, double& t) {
         return !(m.u < 0 || m.u > 1 || m.v_weight < 0 || m.u + m.v_weight > 1 || t < ray.t_min || t > ray.t_max);
       })},
      {"T11", "a zero determinant is replaced by a small one", Verdict::fail, "class",
       triangles([](const Double& m, const Vertices& v, const Ray& ray, double& t) {
         if (m.determinant != 0) return m.inside() && ray.contains(t);
         t = length(v[0] - ray.origin) / length(ray.direction);
         return true;
       })},
      {"T12", "weights above an epsilon of 1e-3", Verdict::fail, "parity", inset(1e-3), Right::tracer, 0.02},
      {"T12", "hits through edges counted twice, a little apart", Verdict::fail, "parity",
       spoiled([right = right_formulas().hits](Formulas& f) {
         f.contract.matrices = false;
         f.hits = [right](const Shape& shape, const Ray& ray) {
           std::vector<LocalHit> hits = right(shape, ray);
           for (LocalHit& hit : hits) hit.t *= 1 + 1e-9 * (hit.primitive % 2);
           return hits;
         };
       }),
       Right::tracer, 0.02},
      {"leak-mesh", "strict comparisons, where neighbours share an edge", Verdict::fail, "escape", inset(0)},
      {"leak-mesh-placed", "strict comparisons, where neighbours share an edge", Verdict::fail, "escape", inset(0),
       Right::tracer, 0.02},
  };
}

}  // namespace plumb::planted
