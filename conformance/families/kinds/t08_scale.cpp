#include "conformance/families/triangles.h"

namespace plumb {
namespace {

/// What over- and underflows in single precision, and for doubles in every second case what does in double: the same
/// shares of the exponents.
double scale(Random& random, const Rounding& rounded) {
  const bool wide = !rounded.is_float() && random.coin();
  if (random.coin()) return wide ? random.magnitude(1e80, 1e140) : random.magnitude(1e10, 4e17);
  return wide ? random.magnitude(1e-190, 1e-65) : random.magnitude(1e-24, 1e-8);
}

FamilyCase scale_case(Random& random, const Rounding& rounded) {
  const double size = scale(random, rounded);
  const Vertices triangle = ordinary_triangle(random, rounded, {}, size);
  std::vector<Ray> rays;
  while (rays.size() < kRaysPerCase) {
    const Point3 target = any_point(random, triangle);
    const Point3 origin = facing_origin(random, triangle, size, rounded);
    rays.push_back(ray_to(origin, target, rounded));
  }
  return triangle_case(triangle, std::move(rays), rounded);
}

}  // namespace

extern const FamilyKind t08_scale_kind{
    .id = "T8",
    .name = "huge and small",
    .recipe =
        "everything, the direction too, at sizes of 1e10 to 4e17 or 1e-24 to 1e-8 (double: half of the cases 1e80 to "
        "1e140 or 1e-190 to 1e-65)",
    .mistake = "the determinant, a product of three lengths, overflows or underflows",
    .make = [](std::uint64_t seed, plumb_precision precision) { return family_of("T8", scale_case, seed, precision); },
};

}  // namespace plumb
