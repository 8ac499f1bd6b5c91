#include "conformance/families/solids.h"

namespace plumb {
namespace {

FamilyCase flat_box_case(Random& random, const Rounding& rounded) {
  Shape box = ordinary_box(random, rounded);
  const int flat = random.integer(0, 2);
  const int second = random.one_in(8) ? (flat + 1) % 3 : flat;
  for (const int axis : {flat, second}) box.max[axis] = box.min[axis];
  return case_of(box, control_rays(random, box, rounded));
}

}  // namespace

extern const FamilyKind b02_flat_box_kind{
    .id = "B2",
    .name = "flat box",
    .recipe = "boxes without thickness along one axis, now and then two",
    .mistake = "entry < exit is false where both are the same, so the box is missed",
    .make = [](std::uint64_t seed,
               plumb_precision precision) { return family_of("B2", flat_box_case, seed, precision); },
};

}  // namespace plumb
