#include "conformance/families/placed.h"

namespace plumb {
namespace {

Groups right_angles(Random& random) {
  Groups groups;
  for (int left = random.integer(1, 4); left > 0; --left) {
    const Vec3 quarters{random.whole(4), random.whole(4), random.whole(4)};
    Vec3 angles = 90 * quarters;
    if (random.coin()) angles = Vec3{}, angles[random.integer(0, 2)] = random.coin() ? 90 : 180;
    groups.push_back({{TransformStep::Kind::rotate, angles}});
    if (random.coin()) groups.back().push_back(random_translation(random));
  }
  return groups;
}

FamilyCase right_angle_case(Random& random, const Rounding& rounded) {
  Groups groups = right_angles(random);
  const Shape shape = any_shape(random, rounded);
  const AffineMatrix matrix = rounded(product_of(groups));
  std::vector<Ray> rays = placed_rays(random, shape, matrix, rounded);
  for (std::size_t i = 0; i < rays.size(); i += 2) {
    const Point3 target = rounded(mapped(matrix, inside_of(random, shape)));
    const int axis = random.integer(0, 2);
    Ray& ray = rays[i];
    ray = {target, {}};
    ray.direction[axis] = random.sign();
    ray.origin[axis] = rounded(target[axis] - 8 * ray.direction[axis]);
  }
  return placed_case(shape, std::move(groups), std::move(rays), rounded);
}

}  // namespace

extern const FamilyKind m04_right_angles_kind{
    .id = "M4",
    .name = "right angles",
    .recipe =
        "one to four nested rotations by multiples of 90 degrees, with translations; every second ray runs along an "
        "axis",
    .mistake = "cos 90 = 6e-17 in radians leaves dust where a zero should stand",
    .make = [](std::uint64_t seed,
               plumb_precision precision) { return family_of("M4", right_angle_case, seed, precision); },
};

}  // namespace plumb
