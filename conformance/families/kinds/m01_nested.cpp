#include "conformance/families/placed.h"

namespace plumb {
namespace {

FamilyCase nested_case(Random& random, const Rounding& rounded) {
  const double largest_condition = rounded.pick(1e4, 1e12);
  while (true) {
    const int depth = random.integer(1, 8);
    const int bits = random.integer(0, rounded.is_float() ? 13 : 39);
    Groups groups = random_groups(random, depth, bits);
    if (!(matrix_condition(rounded(product_of(groups))) <= largest_condition)) continue;
    const Shape shape = any_shape(random, rounded);
    return placed_case(random, shape, std::move(groups), rounded);
  }
}

}  // namespace

extern const FamilyKind m01_nested_kind{
    .id = "M1",
    .name = "nested",
    .recipe =
        "one to eight nested groups of a translation, a rotation and a scale, condition 1 to 1e12 (float: to 1e4)",
    .mistake = "t, where the direction is normalised on the way; and the rounding of the inverse",
    .make = [](std::uint64_t seed, plumb_precision precision) { return family_of("M1", nested_case, seed, precision); },
};

}  // namespace plumb
