#include "reference/solid_hit.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "reference/algebraic_t.h"
#include "reference/solid_filter.h"
#include "reference/solid_polynomial.h"
#include "reference/solid_rational.h"

namespace plumb {
namespace {

bool in_domain(const Shape& s) {
  const bool size = std::isfinite(s.radius) && s.radius >= 0 && is_finite(s.center);
  const bool height = std::isfinite(s.height) && s.height >= 0;
  switch (s.kind) {
    case ShapeKind::sphere:
      return size;
    case ShapeKind::cylinder:
      return size && height;
    case ShapeKind::cone:
      return size && height && std::isfinite(s.tip_z) && s.tip_z != s.center.z;
    case ShapeKind::box:
      return is_finite(s.min) && is_finite(s.max) && s.min.x <= s.max.x && s.min.y <= s.max.y && s.min.z <= s.max.z;
    default:
      return false;
  }
}

bool in_domain(const PlacedShape& placed, const Ray& ray) {
  for (const auto& row : placed.world_from_object)
    for (const double entry : row)
      if (!std::isfinite(entry)) return false;
  return in_domain(placed.shape) && is_finite(ray.origin) && is_finite(ray.direction) && ray.direction != Vec3{} &&
         ray.t_min <= ray.t_max;
}

bool same(const ExactCrossing& a, const ExactCrossing& b) {
  return a.t == b.t && a.t_double == b.t_double && a.place == b.place && a.free == b.free && a.part == b.part &&
         a.position == b.position && a.normal == b.normal;
}

}  // namespace

ExactHit solid_hit(const PlacedShape& shape, const Ray& ray, ExactPath path, StageCounters& counters) {
  if (!in_domain(shape, ray)) return {HitClass::unsupported, false, {}};
  if (path == ExactPath::rational) {
    ++counters.rational;
    return rational_solid_hit(shape, ray);
  }
  if (path == ExactPath::filtered) {
    if (auto hit = filtered_solid_hit(shape, ray)) {
      ++counters.filter;
      return *std::move(hit);
    }
  }
  ++counters.expansion;
  return polynomial_solid_hit(shape, ray,
                              path == ExactPath::filtered ? SolidRounding::balls_first : SolidRounding::exact);
}

AlgebraicT solid_crossing_t(const PlacedShape& shape, const Ray& ray, const ExactCrossing& crossing) {
  if (in_domain(shape, ray)) {
    std::vector<AlgebraicT> roots;
    const ExactHit hit = rational_solid_hit(shape, ray, &roots);
    const auto found = std::find_if(hit.crossings.begin(), hit.crossings.end(),
                                    [&](const ExactCrossing& other) { return same(crossing, other); });
    if (found != hit.crossings.end()) return roots[static_cast<std::size_t>(found - hit.crossings.begin())];
  }
  throw std::invalid_argument("solid_crossing_t: the crossing is none of this ray and shape");
}

}  // namespace plumb
