#include <cmath>

#include "conformance/families/lattice.h"
#include "conformance/families/solids.h"

namespace plumb {
namespace {

/// Three ways to f.d = 0 without a rounding: whole numbers, an axis, or f = 0.
Ray perpendicular_ray(Random& random, const Vec3& center, const Rounding& rounded) {
  switch (random.below(3)) {
    case 0: {
      const Vec3 direction = lattice_vector(random, rounded.pick(0x1p9, 0x1p20));
      return {to_point(center + lattice_perpendicular(random, direction)), direction};
    }
    case 1: {
      const int axis = random.integer(0, 2);
      Vec3 direction, out = lattice_vector(random, rounded.pick(0x1p9, 0x1p20));
      direction[axis] = rounded(random.between(-2, 2));
      out[axis] = 0;
      return {to_point(center + out), direction == Vec3{} ? Vec3{0, 0, 1} : direction};
    }
    default:
      return {to_point(center), rounded(random_direction(random))};
  }
}

FamilyCase b_zero_case(Random& random, const Rounding& rounded) {
  const Vec3 center = lattice_vector(random, rounded.pick(0x1p12, 0x1p30));
  const Ray first = perpendicular_ray(random, center, rounded);
  const double distance = length(first.origin - to_point(center));
  // As far as the first origin, or as an axis leads exactly: that one lies on the sphere then.
  const double radius = random.one_in(4) ? std::floor(distance) + 1 : distance * random.between(0.5, 4) + 1;
  std::vector<Ray> rays{first};
  while (rays.size() < kRaysPerCase) rays.push_back(perpendicular_ray(random, center, rounded));
  const Shape sphere = sphere_of(to_point(center), rounded(radius));
  for (const double sign : {-1.0, 1.0}) {
    const Vec3 out{sign * std::floor(sphere.radius), 0, 0};
    rays[rays.size() - (sign < 0 ? 1 : 2)] = {to_point(center + out), rounded(Vec3{0, random.between(-1, 1), 1})};
  }
  return solid_case(sphere, std::move(rays), rounded);
}

}  // namespace

extern const FamilyKind s05_b_zero_kind{
    .id = "S5",
    .name = "b = 0",
    .recipe =
        "direction and way to the centre are exactly perpendicular, from inside, outside or on the sphere, or the "
        "origin is the centre",
    .mistake = "sgn(0) = 0 in the stable form of the roots gives 0 and c / 0",
    .make = [](std::uint64_t seed, plumb_precision precision) { return family_of("S5", b_zero_case, seed, precision); },
};

}  // namespace plumb
