#include "conformance/families/placed.h"

namespace plumb {
namespace {

FamilyCase ellipsoid_case(Random& random, const Rounding& rounded) {
  const Shape shape = random.coin() ? ordinary_sphere(random, rounded) : any_shape(random, rounded);
  Groups groups;
  for (int left = random.integer(1, 3); left > 0; --left) {
    // In this order a sphere is scaled, then turned: an ellipsoid askew.
    groups.push_back({random_translation(random), random_rotation(random), random_scale(random, 4)});
  }
  return placed_case(random, shape, std::move(groups), rounded);
}

}  // namespace

extern const FamilyKind a01_ellipsoid_kind{
    .id = "A1",
    .name = "ellipsoid box",
    .recipe = "rotated, scaled spheres and other solids, for their bounding boxes",
    .mistake =
        "the box around the corners of the box is up to sqrt(3) too large, and the right formula without directed "
        "rounding fails to contain",
    .make = [](std::uint64_t seed,
               plumb_precision precision) { return family_of("A1", ellipsoid_case, seed, precision); },
};

}  // namespace plumb
