#include "conformance/families/lattice.h"
#include "conformance/families/placed.h"

namespace plumb {
namespace {

Groups stretch(Random& random, int axis) {
  const double factors[] = {0.125, 0.25, 0.5, 2, 3, 4, 8};
  TransformStep scale{TransformStep::Kind::scale, {1, 1, 1}};
  scale.value[axis] = factors[random.below(7)];
  Groups groups{{scale}};
  if (random.coin()) {
    groups.insert(groups.begin(), {random_translation(random), random_rotation(random)});
  }
  return groups;
}

/// A triangle whose normal is exactly this: spanned by two of the directions in its plane, in eighths.
Shape facing_triangle(Random& random, const Vec3& normal, int axis, int other) {
  Vec3 across, along;
  across[axis] = normal[other];
  across[other] = -normal[axis];
  along[3 - axis - other] = 1;
  const Vec3 middle = lattice_vector(random, 16) / 8;
  const double wide = random.integer(4, 12) / 8.0;
  const double high = random.integer(4, 12) / 8.0;
  Shape shape;
  shape.vertices = {to_point(middle - wide * across - high * along), to_point(middle + wide * across),
                    to_point(middle + high * along)};
  if (dot(normal_of(shape.vertices), normal) < 0) std::swap(shape.vertices[0], shape.vertices[1]);
  return shape;
}

FamilyCase non_uniform_case(Random& random, const Rounding& rounded) {
  // A cylinder's side has no normal along z.
  const bool triangle = random.one_in(3);
  const bool cylinder = !triangle && random.coin();
  const int axis = random.integer(0, cylinder ? 1 : 2);
  const int other = cylinder ? 1 - axis : (axis + random.integer(1, 2)) % 3;
  Vec3 normal;
  normal[axis] = random.sign();
  normal[other] = random.sign();
  const Shape shape = triangle   ? facing_triangle(random, normal, axis, other)
                      : cylinder ? ordinary_cylinder(random, rounded)
                                 : ordinary_sphere(random, rounded);
  Groups groups = stretch(random, axis);
  const AffineMatrix matrix = rounded(product_of(groups));
  std::vector<Ray> rays;
  while (rays.size() < kRaysPerCase) {
    const Vec3 lean = 0.2 * random_direction(random);
    const Point3 target = triangle ? inner_point(random, shape.vertices)
                                   : shape.center + shape.radius * normalized(normal) + 0.1 * shape.radius * lean;
    const Point3 origin = target + random.between(1, 3) * (normal + lean);
    rays.push_back(ray_to(rounded(mapped(matrix, origin)), mapped(matrix, target), rounded));
  }
  return placed_case(shape, std::move(groups), std::move(rays), rounded);
}

}  // namespace

extern const FamilyKind m02_non_uniform_kind{
    .id = "M2",
    .name = "non-uniform",
    .recipe =
        "one axis scaled by 1/8 to 8 and hits where the normal is about (1, 1, 0), between the scaled axis and another",
    .mistake = "normals taken along by the matrix instead of its inverse transpose: 37 degrees off at diag(2, 1, 1)",
    .make = [](std::uint64_t seed,
               plumb_precision precision) { return family_of("M2", non_uniform_case, seed, precision); },
};

}  // namespace plumb
