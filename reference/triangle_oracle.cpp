#include "reference/triangle_oracle.h"

#include <algorithm>

#include "reference/expansion.h"
#include "reference/triangle_crossing.h"

namespace plumb {
namespace {

bool in_range(const Point3& p) { return in_expansion_range(p.x) && in_expansion_range(p.y) && in_expansion_range(p.z); }
bool in_range(const Vec3& v) { return in_expansion_range(v.x) && in_expansion_range(v.y) && in_expansion_range(v.z); }

/// A vertex as seen from the origin; exact.
struct SeenPoint {
  SeenPoint(const Point3& p, const Point3& origin)
      : x(exact_difference(p.x, origin.x)), y(exact_difference(p.y, origin.y)), z(exact_difference(p.z, origin.z)) {}
  Expansion<2> x, y, z;
};

template <class Coordinate>
struct Triple {
  Coordinate x, y, z;
};

template <class A, class B>
auto cross(const A& a, const B& b) {
  auto x = a.y * b.z - a.z * b.y;
  return Triple<decltype(x)>{x, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class A, class B>
auto dot(const A& a, const B& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

Sign to_sign(int sign) { return static_cast<Sign>(sign); }

/// By the formulas of triangle_filter.h; degree three, and four where the range is asked.
TriangleDecision decide_by_expansions(const Ray& ray, const Point3& a, const Point3& b, const Point3& c) {
  const SeenPoint seen_a(a, ray.origin), seen_b(b, ray.origin), seen_c(c, ray.origin);
  const auto turned = cross(seen_b, ray.direction);
  const auto side = cross(seen_a, seen_c);
  const auto u = dot(turned, seen_c);
  auto w = dot(turned, seen_a);
  w.negate();
  const auto v = dot(side, ray.direction);
  TriangleDecision decision{HitClass::miss, DecidedBy::expansion};
  decision.u = to_sign(u.sign());
  decision.v = to_sign(v.sign());
  decision.w = to_sign(w.sign());
  const int low = std::min({u.sign(), v.sign(), w.sign()}), high = std::max({u.sign(), v.sign(), w.sign()});
  if (low < 0 && high > 0) return decision;
  // No mixed signs: D has that of those which are not zero.
  const int d_sign = high > 0 ? 1 : low;
  const auto t = dot(side, seen_b);
  decision.d = to_sign(d_sign);
  decision.t = to_sign(t.sign());
  const auto side_of = [&](double tau) {
    if (std::isinf(tau)) return tau < 0 ? 1 : -1;
    return d_sign * (tau == 0 ? t.sign() : (t - (u + v + w) * tau).sign());
  };
  if (d_sign == 0 || side_of(ray.t_min) < 0 || side_of(ray.t_max) > 0) return decision;
  decision.hit_class = low == 0 || high == 0 ? HitClass::boundary : HitClass::hit;
  return decision;
}

}  // namespace

bool is_valid(const Ray& ray) {
  return is_finite(ray.origin) && is_finite(ray.direction) && ray.direction != Vec3() && ray.t_min <= ray.t_max;
}

TriangleDecision decide_triangle_exactly(const Ray& ray, const Point3& a, const Point3& b, const Point3& c,
                                         StageCounters& counters) {
  const auto bound_in_range = [](double tau) { return std::isinf(tau) || in_expansion_range(tau); };
  if (in_range(a) && in_range(b) && in_range(c) && in_range(ray.origin) && in_range(ray.direction) &&
      bound_in_range(ray.t_min) && bound_in_range(ray.t_max) && ray.t_min <= ray.t_max && ray.direction != Vec3())
      [[likely]] {
    ++counters.expansion;
    return decide_by_expansions(ray, a, b, c);
  }
  if (!is_valid(ray) || !is_finite(a) || !is_finite(b) || !is_finite(c))
    return {HitClass::unsupported, DecidedBy::filter};
  ++counters.rational;
  return decide_triangle_by_numbers(ray, a, b, c);
}

}  // namespace plumb
