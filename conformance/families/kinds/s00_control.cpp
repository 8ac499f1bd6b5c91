#include "conformance/families/solids.h"

namespace plumb {
namespace {

FamilyCase sphere_case(Random& random, const Rounding& rounded) {
  const Shape sphere = ordinary_sphere(random, rounded);
  return case_of(sphere, control_rays(random, sphere, rounded));
}

}  // namespace

extern const FamilyKind s00_control_kind{
    .id = "S0",
    .name = "control",
    .recipe = "ordinary spheres, rays from outside at inner points or past them by a margin",
    .mistake = "nothing: a program that errs here errs everywhere",
    .make = [](std::uint64_t seed, plumb_precision precision) { return family_of("S0", sphere_case, seed, precision); },
};

}  // namespace plumb
