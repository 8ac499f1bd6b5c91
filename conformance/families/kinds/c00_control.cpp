#include "conformance/families/solids.h"

namespace plumb {
namespace {

FamilyCase round_case(Random& random, const Rounding& rounded) {
  const Shape solid = random.coin() ? ordinary_cylinder(random, rounded) : ordinary_cone(random, rounded);
  return case_of(solid, control_rays(random, solid, rounded));
}

}  // namespace

extern const FamilyKind c00_control_kind{
    .id = "C0",
    .name = "control",
    .recipe = "ordinary cylinders and cones, rays from outside at inner points or past them by a margin",
    .mistake = "nothing: a program that errs here errs everywhere",
    .make = [](std::uint64_t seed, plumb_precision precision) { return family_of("C0", round_case, seed, precision); },
};

}  // namespace plumb
