#include "reference/exact_hit.h"

#include <algorithm>

#include "reference/algebraic_t.h"
#include "reference/solid_hit.h"
#include "reference/triangle_hit.h"

namespace plumb {
namespace {

using Entry = ExactClosest::Entry;

bool is_flat(const PlacedShape& shape) {
  return shape.shape.kind == ShapeKind::triangle || shape.shape.kind == ShapeKind::mesh;
}

AlgebraicT exact_t(const PlacedShape& shape, const Ray& ray, const ExactCrossing& crossing) {
  if (!is_flat(shape)) return solid_crossing_t(shape, ray, crossing);
  const Quotient t = triangle_crossing_t(shape, ray, crossing);
  return {0, t.denominator, -t.numerator, 0};
}

/// The exact order of two entries by t. Enclosures tell numbers apart unless they are the same pair of neighbours.
int compare(const Entry& x, const Entry& y, std::span<const PlacedShape> shapes, const Ray& ray) {
  const Enclosure &s = x.crossing.t, &t = y.crossing.t;
  if (s != t) return std::pair(s.below, s.above) < std::pair(t.below, t.above) ? -1 : 1;
  if (s.exact()) return 0;
  return compare(exact_t(shapes[x.shape], ray, x.crossing), exact_t(shapes[y.shape], ray, y.crossing));
}

}  // namespace

ExactHit exact_hit(const PlacedShape& shape, const Ray& ray, ExactPath path) {
  StageCounters counters;
  return is_flat(shape) ? triangle_hit(shape, ray, path, counters) : solid_hit(shape, ray, path, counters);
}

ExactClosest exact_closest(std::span<const PlacedShape> shapes, const Ray& ray, ExactPath path) {
  ExactClosest closest;
  std::vector<Entry> free;
  for (std::uint32_t i = 0; i < shapes.size(); ++i)
    for (const ExactCrossing& crossing : exact_hit(shapes[i], ray, path).crossings) {
      const Entry entry{i, crossing};
      if (crossing.free) {
        free.push_back(entry);
        continue;
      }
      const int order = closest.winners.empty() ? -1 : compare(entry, closest.winners.front(), shapes, ray);
      if (order < 0) closest.winners.clear();
      if (order <= 0) closest.winners.push_back(entry);
    }
  for (const Entry& entry : free)
    if (closest.winners.empty() || compare(entry, closest.winners.front(), shapes, ray) <= 0)
      closest.free_nearer.push_back(entry);
  return closest;
}

}  // namespace plumb
