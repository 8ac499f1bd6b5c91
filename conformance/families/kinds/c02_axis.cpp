#include <algorithm>

#include "conformance/families/lattice.h"
#include "conformance/families/solids.h"

namespace plumb {
namespace {

/// Sixty-fourths, so that the side and (where the height is a power of two) the caps can be met exactly.
Shape exact_cylinder(Random& random, const Rounding& rounded) {
  const Vec3 place = lattice_vector(random, 128);
  const double radius = random.integer(16, 96) / 64.0;
  const double heights[] = {0x1p-13, 1, 0x1p13, 1e-4, 1e4};
  return cylinder_of(to_point(place / 64), radius, rounded(heights[random.below(5)]));
}

Vec3 axis_direction(Random& random, const Rounding& rounded) {
  const Vec3 across = random_in_plane(random, 0, 1);
  const double tilt = random.coin() ? 0 : random.magnitude(1e-15, 1e-2);
  const double size = random.magnitude(0.25, 4) * random.sign();
  if (random.coin()) {
    const double small = tilt * size;
    return rounded(Vec3{small * across.x, small * across.y, size});
  }
  if (random.coin()) return rounded(size * Vec3{across.x, across.y, tilt});
  return rounded(size * (random.coin() ? Vec3{1, 0, tilt} : Vec3{0, 1, tilt}));
}

/// Where the ray begins across the axis: on it, on the side, within, or without.
Vec3 place_across(Random& random, double radius, const Rounding& rounded) {
  switch (random.below(4)) {
    case 0:
      return {};
    case 1: {
      const double side = random.sign() * radius;
      return random.coin() ? Vec3{side, 0, 0} : Vec3{0, side, 0};
    }
    default: {
      const double share = random.one_in(3) ? random.between(1.05, 2) : random.between(0, 0.95);
      return rounded(share * radius * random_in_plane(random, 0, 1));
    }
  }
}

FamilyCase axis_case(Random& random, const Rounding& rounded) {
  const Shape cylinder = exact_cylinder(random, rounded);
  std::vector<Ray> rays;
  while (rays.size() < kRaysPerCase) {
    const Vec3 direction = axis_direction(random, rounded);
    Vec3 place = place_across(random, cylinder.radius, rounded);
    const double up = random.one_in(4) ? 0.5 * random.sign() : random.between(-0.75, 0.75);
    place.z = up * cylinder.height;
    // A way back along the direction keeps the place on the line, but for its rounding.
    const double back = random.coin() ? 0 : random.between(0, 2) * std::max(1.0, cylinder.height);
    rays.push_back({rounded(cylinder.center + (place - (back / largest(direction)) * direction)), direction});
  }
  return solid_case(cylinder, std::move(rays), rounded);
}

}  // namespace

extern const FamilyKind c02_axis_kind{
    .id = "C2",
    .name = "axis",
    .recipe =
        "rays along a cylinder, across it, or 1e-15 to 1e-2 off either; heights 1e-4, 1 and 1e4; origins on the side, "
        "the axis and the caps too",
    .mistake = "a = 0 in the quadratic gives NaN, or an absolute epsilon decides",
    .make = [](std::uint64_t seed, plumb_precision precision) { return family_of("C2", axis_case, seed, precision); },
};

}  // namespace plumb
