#include <stdexcept>

#include "reference/algebraic_t.h"
#include "reference/solid_hit.h"

namespace plumb {

// Stands in for the solids until they are there.
ExactHit solid_hit(const PlacedShape&, const Ray&, ExactPath, StageCounters&) {
  ExactHit result;
  result.hit_class = HitClass::unsupported;
  return result;
}

AlgebraicT solid_crossing_t(const PlacedShape&, const Ray&, const ExactCrossing&) {
  throw std::logic_error("there are no solids yet");
}

}  // namespace plumb
