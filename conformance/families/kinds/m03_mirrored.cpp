#include "conformance/families/placed.h"

namespace plumb {
namespace {

FamilyCase mirrored_case(Random& random, const Rounding& rounded) {
  const int depth = random.integer(1, 4);
  Groups groups = random_groups(random, depth, 2);
  bool odd = false;
  for (auto& group : groups) {
    for (TransformStep& step : group) {
      if (step.kind != TransformStep::Kind::scale) continue;
      // The last one that is drawn makes the number odd.
      for (int axis = 0; axis < 3; ++axis) {
        const bool last = &group == &groups.back() && axis == 2;
        const bool negative = last ? !odd : random.coin();
        if (negative) step.value[axis] = -step.value[axis];
        odd = odd != negative;
      }
    }
  }
  const Shape shape = any_shape(random, rounded);
  return placed_case(random, shape, std::move(groups), rounded);
}

}  // namespace

extern const FamilyKind m03_mirrored_kind{
    .id = "M3",
    .name = "mirrored",
    .recipe = "nested groups with an odd number of negative scale factors",
    .mistake = "the normal points inward, or back faces are culled that are front faces",
    .make = [](std::uint64_t seed,
               plumb_precision precision) { return family_of("M3", mirrored_case, seed, precision); },
};

}  // namespace plumb
