#include "conformance/families/solids.h"

namespace plumb {
namespace {

FamilyCase box_case(Random& random, const Rounding& rounded) {
  const Shape box = ordinary_box(random, rounded);
  return case_of(box, control_rays(random, box, rounded));
}

}  // namespace

extern const FamilyKind b00_control_kind{
    .id = "B0",
    .name = "control",
    .recipe = "ordinary boxes, rays from outside at inner points or past them by a margin",
    .mistake = "nothing: a program that errs here errs everywhere",
    .make = [](std::uint64_t seed, plumb_precision precision) { return family_of("B0", box_case, seed, precision); },
};

}  // namespace plumb
