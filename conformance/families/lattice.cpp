#include "conformance/families/lattice.h"

namespace plumb {

Vec3 lattice_vector(Random& random, double reach) {
  while (true) {
    const double whole = std::floor(reach);
    const Vec3 v{random.whole(whole), random.whole(whole), random.whole(whole)};
    if (v != Vec3{}) return v;
  }
}

Vec3 lattice_perpendicular(Random& random, const Vec3& axis) {
  while (true) {
    const Vec3 v = cross(axis, lattice_vector(random, 2));
    if (v != Vec3{}) return v;
  }
}

Point3 LatticeTriangle::boundary_point(Random& random) const {
  const int i = random.one_in(4) ? 0 : random.integer(1, steps - 1);
  switch (random.below(3)) {
    case 0:
      return point(i, 0);
    case 1:
      return point(0, steps - i);
    default:
      return point(steps - i, i);
  }
}

Point3 LatticeTriangle::inner_point(Random& random) const {
  const int i = random.integer(1, steps - 2);
  return point(i, random.integer(1, steps - 1 - i));
}

Point3 LatticeTriangle::near_point(Random& random) const {
  const int i = random.integer(-1, steps + 1);
  return point(i, random.integer(-1, steps + 1));
}

LatticeTriangle lattice_triangle(Random& random, double reach) {
  while (true) {
    LatticeTriangle triangle;
    triangle.steps = random.integer(3, 8);
    triangle.a = lattice_vector(random, reach);
    triangle.p = lattice_vector(random, reach / triangle.steps);
    triangle.q = lattice_vector(random, reach / triangle.steps);
    // Leaves out the nearly parallel too, which are the subject of other families.
    const Vec3 n = cross(triangle.p / largest(triangle.p), triangle.q / largest(triangle.q));
    if (dot(n, n) > 0x1p-6) return triangle;
  }
}

LatticeRotation lattice_rotation(Random& random, double reach) {
  while (true) {
    const double w = random.whole(reach), x = random.whole(reach), y = random.whole(reach), z = random.whole(reach);
    const double length = w * w + x * x + y * y + z * z;
    if (length == 0) continue;
    return {{Vec3{w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)},
             Vec3{2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)},
             Vec3{2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z}},
            length};
  }
}

}  // namespace plumb
