#include <algorithm>
#include <cmath>

#include "conformance/checks/testing/planted_fault.h"

namespace plumb::planted {
namespace {

using Hits = std::vector<LocalHit>;

Hits in_range(std::initializer_list<double> roots, const Ray& ray) {
  Hits hits;
  for (const double t : roots)
    if (ray.contains(t)) hits.push_back({.t = t});
  return hits;
}

template <class Formula>
std::function<std::unique_ptr<Subject>()> solids(unsigned shapes, Formula formula) {
  return spoiled([=](Formulas& f) {
    f.contract.matrices = false;
    f.contract.shapes = shapes;
    f.hits = formula;
  });
}

/// a t^2 + 2 b t + c of a ray and a sphere.
template <class Real>
struct Quadratic {
  Quadratic(const Shape& sphere, const Ray& ray) {
    const Real f[3] = {Real(ray.origin.x) - Real(sphere.center.x), Real(ray.origin.y) - Real(sphere.center.y),
                       Real(ray.origin.z) - Real(sphere.center.z)};
    const Real d[3] = {Real(ray.direction.x), Real(ray.direction.y), Real(ray.direction.z)};
    a = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    b = f[0] * d[0] + f[1] * d[1] + f[2] * d[2];
    c = f[0] * f[0] + f[1] * f[1] + f[2] * f[2] - Real(sphere.radius) * Real(sphere.radius);
  }
  Real discriminant() const { return b * b - a * c; }
  Real a, b, c;
};

Hits textbook_in_float(const Shape& sphere, const Ray& ray) {
  const Quadratic<float> q(sphere, ray);
  if (!(q.discriminant() >= 0)) return {};
  const float root = std::sqrt(q.discriminant());
  return in_range({static_cast<double>((-q.b - root) / q.a), static_cast<double>((-q.b + root) / q.a)}, ray);
}

Hits as_if_the_direction_were_unit(const Shape& sphere, const Ray& ray) {
  Quadratic<double> q(sphere, ray);
  q.a = 1;
  if (q.discriminant() < 0) return {};
  const double root = std::sqrt(q.discriminant());
  return in_range({-q.b - root, -q.b + root}, ray);
}

/// The centre and the radius in float, as where a renderer's structures hold them so.
Hits held_in_float(Shape sphere, const Ray& ray) {
  const auto single = [](double x) { return static_cast<double>(static_cast<float>(x)); };
  sphere.center = {single(sphere.center.x), single(sphere.center.y), single(sphere.center.z)};
  sphere.radius = single(sphere.radius);
  return right_formulas().hits(sphere, ray);
}

Hits without_the_grazing(const Shape& sphere, const Ray& ray) {
  const Quadratic<double> q(sphere, ray);
  if (q.discriminant() <= 1e-4 * q.a * sphere.radius * sphere.radius) return {};
  return right_formulas().hits(sphere, ray);
}

/// Whatever the range says, the smaller root.
Hits always_the_near_root(const Shape& sphere, const Ray& ray) {
  const Hits right = right_formulas().hits(sphere, ray);
  if (right.empty()) return {};
  const Quadratic<double> q(sphere, ray);
  return {{.t = (-q.b - std::sqrt(std::max(0.0, q.discriminant()))) / q.a}};
}

/// The "stable" form with a sign of b that is 0 for 0.
Hits with_sign_of_zero(const Shape& sphere, const Ray& ray) {
  const Quadratic<double> q(sphere, ray);
  if (q.discriminant() < 0) return {};
  const double sign = q.b > 0 ? 1 : q.b < 0 ? -1 : 0;
  const double sum = -q.b - sign * std::sqrt(q.discriminant());
  return in_range({sum / q.a, q.c / sum}, ray);
}

/// The side and the caps each by itself, both without their rim. `flat` is the |d_z| up to which the caps count as
/// missed.
Hits side_and_caps(const Shape& cylinder, const Ray& ray, double flat, bool capped = true) {
  const Vec3 f = ray.origin - cylinder.center;
  const Vec3 d = ray.direction;
  const double half = cylinder.height / 2, r = cylinder.radius;
  Hits hits;
  const double a = d.x * d.x + d.y * d.y;
  const double b = f.x * d.x + f.y * d.y;
  const double c = f.x * f.x + f.y * f.y - r * r;
  if (a > 0 && b * b - a * c >= 0) {
    const double q = -b - std::copysign(std::sqrt(b * b - a * c), b);
    for (const double t : {q / a, c / q})
      if (std::fabs(f.z + t * d.z) < half && ray.contains(t)) hits.push_back({.t = t});
  }
  for (const double z : {-half, half}) {
    const double t = (z - f.z) / d.z;
    const double x = f.x + t * d.x, y = f.y + t * d.y;
    if (capped && std::fabs(d.z) > flat && x * x + y * y < r * r && ray.contains(t)) hits.push_back({.t = t});
  }
  return hits;
}

Hits strict(const Shape& cylinder, const Ray& ray) { return side_and_caps(cylinder, ray, 0); }
Hits caps_by_epsilon(const Shape& cylinder, const Ray& ray) { return side_and_caps(cylinder, ray, 1e-4); }
Hits open_tube(const Shape& cylinder, const Ray& ray) { return side_and_caps(cylinder, ray, 0, false); }

}  // namespace

std::vector<Fault> round_solid_faults() {
  return {
      {"S0", "the direction is taken to be unit", Verdict::fail, "class",
       solids(PLUMB_SPHERES, as_if_the_direction_were_unit)},
      {"S1", "the textbook quadratic in float", Verdict::fail, "class", solids(PLUMB_SPHERES, textbook_in_float)},
      {"S2", "the radius is held in float", Verdict::fail, "t", solids(PLUMB_SPHERES, held_in_float)},
      {"S3", "discriminants up to 1e-4 count as tangent, and those as misses", Verdict::fail, "class",
       solids(PLUMB_SPHERES, without_the_grazing)},
      {"S4", "the near root, though it lies before the range", Verdict::fail, "t",
       solids(PLUMB_SPHERES, always_the_near_root)},
      {"S5", "sgn(0) = 0 in the stable form", Verdict::fail, "not_finite", solids(PLUMB_SPHERES, with_sign_of_zero)},
      {"C0", "a cylinder without caps", Verdict::fail, "class", solids(PLUMB_CYLINDERS, open_tube)},
      {"C1", "side and caps apart, both without the rim", Verdict::fail, "escape", solids(PLUMB_CYLINDERS, strict)},
      {"C2", "caps left out where |d_z| is below 1e-4", Verdict::fail, "escape",
       solids(PLUMB_CYLINDERS, caps_by_epsilon)},
      {"leak-solid", "side and caps apart, both without the rim", Verdict::fail, "escape",
       solids(PLUMB_CYLINDERS, strict)},
      {"leak-solid-placed", "side and caps apart, both without the rim", Verdict::fail, "escape",
       solids(PLUMB_CYLINDERS, strict)},
  };
}

}  // namespace plumb::planted
