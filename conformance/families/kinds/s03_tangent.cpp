#include <algorithm>
#include <cmath>

#include "conformance/families/lattice.h"
#include "conformance/families/solids.h"

namespace plumb {
namespace {

/// Tangent to the last bit: the radius times a row of a rotation leads to the point, another row along the tangent.
FamilyCase exact_tangent_case(Random& random, const Rounding& rounded) {
  const LatticeRotation turn = lattice_rotation(random, rounded.pick(0x1p4, 0x1p10));
  const double times = 1 + std::fabs(random.whole(rounded.pick(0x1p3, 0x1p10)));
  const Vec3 center = lattice_vector(random, rounded.pick(0x1p12, 0x1p30));
  std::vector<Ray> rays;
  while (rays.size() < kRaysPerCase) {
    const std::size_t row = random.below(3);
    const std::size_t other = (row + 1 + random.below(2)) % 3;
    const Vec3 out = random.sign() * times * turn.rows[row];
    const Vec3 along = random.sign() * turn.rows[other];
    const Vec3 origin = center + out - double(random.integer(1, 8)) * along;
    rays.push_back({to_point(origin), along});
  }
  return case_of(sphere_of(to_point(center), times * turn.length), std::move(rays),
                 1 / std::sqrt(8 * rounded.unit_roundoff()));
}

FamilyCase near_tangent_case(Random& random, const Rounding& rounded) {
  const Shape sphere = ordinary_sphere(random, rounded);
  const double delta = random.magnitude(rounded.pick(1e-8, 1e-16), 1e-2);
  std::vector<Ray> rays;
  while (rays.size() < kRaysPerCase) {
    const Vec3 way = random_direction(random);
    const Vec3 beside = random_perpendicular(random, way);
    const Point3 target = sphere.center + (1 + random.sign() * delta) * sphere.radius * beside;
    const Point3 origin = rounded(target + random.between(1.5, 4) * sphere.radius * way);
    rays.push_back(ray_to(origin, target, rounded));
  }
  // The cosine at the surface is about sqrt(2 delta); what rounding does to delta bounds it.
  const double condition = 1 / std::sqrt(2 * std::max(delta, 4 * rounded.unit_roundoff()));
  return case_of(sphere, std::move(rays), condition);
}

FamilyCase tangent_case(Random& random, const Rounding& rounded) {
  return random.one_in(4) ? exact_tangent_case(random, rounded) : near_tangent_case(random, rounded);
}

}  // namespace

extern const FamilyKind s03_tangent_kind{
    .id = "S3",
    .name = "tangent",
    .recipe =
        "rays that pass the middle by 1 +- delta radii, delta from 1e-16 (float: 1e-8) to 1e-2, and exact tangents in "
        "whole numbers",
    .mistake = "the class: the discriminant is a rounding error",
    .make = [](std::uint64_t seed,
               plumb_precision precision) { return family_of("S3", tangent_case, seed, precision); },
};

}  // namespace plumb
