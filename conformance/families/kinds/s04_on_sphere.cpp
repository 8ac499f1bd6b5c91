#include <cmath>

#include "conformance/families/lattice.h"
#include "conformance/families/solids.h"

namespace plumb {
namespace {

struct Start {
  Shape sphere;
  std::vector<Point3> origins;
};

Start exact_start(Random& random, const Rounding& rounded) {
  const LatticeRotation turn = lattice_rotation(random, rounded.pick(0x1p4, 0x1p10));
  const double times = 1 + std::fabs(random.whole(rounded.pick(0x1p3, 0x1p10)));
  const Vec3 center = lattice_vector(random, rounded.pick(0x1p12, 0x1p30));
  Start start{sphere_of(to_point(center), times * turn.length), {}};
  while (start.origins.size() < kRaysPerCase) {
    const std::size_t row = random.below(3);
    const Vec3 out = random.sign() * times * turn.rows[row];
    start.origins.push_back(to_point(center + out));
  }
  return start;
}

Start rounded_start(Random& random, const Rounding& rounded) {
  Start start{ordinary_sphere(random, rounded), {}};
  while (start.origins.size() < kRaysPerCase) start.origins.push_back(rounded(surface_point(random, start.sphere)));
  return start;
}

FamilyCase on_sphere_case(Random& random, const Rounding& rounded) {
  const auto [sphere, origins] = random.one_in(4) ? exact_start(random, rounded) : rounded_start(random, rounded);
  // In multiples of the direction, which is about a radius long.
  const double t_min = random.coin() ? 0 : 0x1p-10;
  std::vector<Ray> rays;
  for (const Point3& origin : origins) {
    const Vec3 direction = rounded(sphere.radius * random_direction(random));
    rays.push_back({origin, direction, t_min});
  }
  return solid_case(sphere, std::move(rays), rounded);
}

}  // namespace

extern const FamilyKind s04_on_sphere_kind{
    .id = "S4",
    .name = "on sphere",
    .recipe =
        "the origin lies on the sphere, exactly (whole numbers) or up to rounding, with t_min = 0 or a thousandth of "
        "the radius",
    .mistake = "the near root for the far one, in every second case",
    .make = [](std::uint64_t seed,
               plumb_precision precision) { return family_of("S4", on_sphere_case, seed, precision); },
};

}  // namespace plumb
