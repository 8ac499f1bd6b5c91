#include "conformance/families/placed.h"

namespace plumb {
namespace {

FamilyCase mild_case(Random& random, const Rounding& rounded) {
  const int depth = random.integer(1, 3);
  Groups groups = random_groups(random, depth, 1);
  const Shape shape = any_shape(random, rounded);
  return placed_case(random, shape, std::move(groups), rounded);
}

}  // namespace

extern const FamilyKind m00_control_kind{
    .id = "M0",
    .name = "control",
    .recipe = "ordinary shapes in one to three groups of mild scales",
    .mistake = "nothing: a program that errs here errs everywhere",
    .make = [](std::uint64_t seed, plumb_precision precision) { return family_of("M0", mild_case, seed, precision); },
};

}  // namespace plumb
