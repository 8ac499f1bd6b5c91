#pragma once

#include <cstdint>

#include "reference/exact_hit.h"
#include "reference/stage_counters.h"
#include "reference/triangle_filter.h"

namespace plumb {

/// The sign of an exact number; `unknown` where the answer did not need it.
enum class Sign : std::int8_t { negative = -1, zero = 0, positive = 1, unknown = 2 };

/// Which arithmetic was needed: doubles with a bound, expansions, or numbers of any length.
enum class DecidedBy : std::uint8_t { filter, expansion, rational };

/// What a ray does with a triangle in world space, without numbers. u, v, w, d, t are the signs of U, V, W (the weights
/// of the first, second and third vertex), D = U + V + W and T, with t = T / D; see triangle_filter.h. They are exact;
/// on a miss those of D and T, and of one of the weights, may be unknown.
struct TriangleDecision {
  HitClass hit_class = HitClass::miss;
  DecidedBy by = DecidedBy::filter;
  Sign u = Sign::unknown, v = Sign::unknown, w = Sign::unknown, d = Sign::unknown, t = Sign::unknown;
};

/// The decision without the filter: by expansions where all numbers lie in their range (expansion.h), else by numbers
/// of any length. All signs are known, but those of T and D where the weights alone prove a miss, and of all where the
/// answer is `unsupported`.
TriangleDecision decide_triangle_exactly(const Ray& ray, const Point3& a, const Point3& b, const Point3& c,
                                         StageCounters& counters);

/// The class of exact_hit() for one ray and one triangle in world space, by the filter where that suffices. For
/// millions of pairs a second. A coplanar or degenerate one is a miss; numbers that are not finite, a zero direction
/// and t_min > t_max are `unsupported`.
inline TriangleDecision decide_triangle(const Ray& ray, const Point3& a, const Point3& b, const Point3& c,
                                        StageCounters& counters) {
  const TriangleEstimate estimate = estimate_triangle(seen_triangle(ray.origin, a, b, c), ray.direction);
  const FilterVerdict verdict = judge_estimate(estimate, ray.t_min, ray.t_max);
  if (verdict == FilterVerdict::undecided) [[unlikely]]
    return decide_triangle_exactly(ray, a, b, c, counters);
  ++counters.filter;
  const auto sign = [](double x, double bound) {
    return x > bound ? Sign::positive : x < -bound ? Sign::negative : Sign::unknown;
  };
  TriangleDecision decision{verdict == FilterVerdict::hit ? HitClass::hit : HitClass::miss, DecidedBy::filter};
  decision.u = sign(estimate.u, estimate.weight_bound);
  decision.v = sign(estimate.v, estimate.weight_bound);
  decision.w = sign(estimate.w, estimate.weight_bound);
  decision.t = sign(estimate.t, estimate.t_bound);
  if (decision.u == decision.v && decision.v == decision.w) decision.d = decision.u;
  return decision;
}

/// How far the ray's line passes from the nearest edge's line: min(|U|, |V|, |W|) / (|d|_1 s e unit), with s the
/// largest |coordinate| of a vertex as seen from the origin and e that of an edge vector. `unit` is the unit roundoff
/// in which the answer counts: 2^-24 for float, 2^-53 for double. The determinants, s and e are exact, the quotient is
/// correctly rounded. 0 for a degenerate triangle, for an origin on all three vertices, and for a zero direction. All
/// numbers must be finite (NaN otherwise).
double edge_margin(const Ray& ray, const Point3& a, const Point3& b, const Point3& c, double unit);

}  // namespace plumb
