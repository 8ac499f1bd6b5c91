#include "renderer/math/bounds3.h"

namespace plumb {

void Bounds3::extend(const Point3& p) {
  for (int axis = 0; axis < 3; ++axis) {
    if (p[axis] < min[axis]) min[axis] = p[axis];
    if (p[axis] > max[axis]) max[axis] = p[axis];
  }
}

void Bounds3::extend(const Bounds3& other) {
  if (other.empty()) return;
  extend(other.min);
  extend(other.max);
}

bool Bounds3::contains(const Point3& p) const {
  return p.x >= min.x && p.x <= max.x && p.y >= min.y && p.y <= max.y && p.z >= min.z && p.z <= max.z;
}

double Bounds3::half_area() const {
  if (empty()) return 0;
  const Vec3 d = max - min;
  return d.x * d.y + d.y * d.z + d.z * d.x;
}

Point3 Bounds3::corner(int index) const {
  return {(index & 1) ? max.x : min.x, (index & 2) ? max.y : min.y, (index & 4) ? max.z : min.z};
}

Point3 Bounds3::center() const {
  // Halved before adding, so that corners near the largest double do not overflow.
  return {0.5 * min.x + 0.5 * max.x, 0.5 * min.y + 0.5 * max.y, 0.5 * min.z + 0.5 * max.z};
}

}  // namespace plumb
