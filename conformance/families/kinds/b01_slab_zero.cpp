#include "conformance/families/solids.h"

namespace plumb {
namespace {

/// In a face's plane as a rule.
double place_on_axis(Random& random, const Shape& box, int axis, const Rounding& rounded) {
  const double face = random.coin() ? box.min[axis] : box.max[axis];
  switch (random.below(6)) {
    case 0:
      return rounded.next(face, random.coin() ? box.min[axis] - 1 : box.max[axis] + 1);
    case 1:
      return rounded(random.between(box.min[axis], box.max[axis]));
    default:
      return face;
  }
}

Ray slab_ray(Random& random, const Shape& box, const Rounding& rounded) {
  Point3 origin = random.one_in(4) ? rounded(inner_point(random, box)) : outside_origin(random, box, rounded);
  const Point3 target = random.one_in(4) ? missed_target(random, box, origin) : inner_point(random, box);
  Vec3 direction = ray_to(origin, target, rounded).direction;
  const int first = random.integer(0, 2);
  const int second = random.coin() ? first : (first + random.integer(1, 2)) % 3;
  for (const int axis : {first, second}) {
    origin[axis] = place_on_axis(random, box, axis, rounded);
    direction[axis] = 0 * random.sign();
  }
  return {origin, direction};
}

FamilyCase slab_zero_case(Random& random, const Rounding& rounded) {
  const Shape box = ordinary_box(random, rounded);
  std::vector<Ray> rays;
  while (rays.size() < kRaysPerCase) rays.push_back(slab_ray(random, box, rounded));
  return case_of(box, std::move(rays));
}

}  // namespace

extern const FamilyKind b01_slab_zero_kind{
    .id = "B1",
    .name = "slab zero",
    .recipe =
        "one or two components of the direction are +0 or -0, and the origin lies in the plane of a face, a step "
        "beside it or between two",
    .mistake = "0 * inf is NaN in the slab test",
    .make = [](std::uint64_t seed,
               plumb_precision precision) { return family_of("B1", slab_zero_case, seed, precision); },
};

}  // namespace plumb
