#include "meshes/editing/transform_mesh.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "renderer/math/exact_sum.h"

namespace plumb {
namespace {

/// Powers of two, which round nothing, keep the squares in range.
Normal3 made_unit(const Normal3& n) {
  const double largest = std::max({std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)});
  if (!(largest > 0)) return {};
  const int exponent = std::ilogb(largest);
  return normalized(Normal3{std::ldexp(n.x, -exponent), std::ldexp(n.y, -exponent), std::ldexp(n.z, -exponent)});
}

}  // namespace

bool is_mirroring(const AffineMatrix& matrix) {
  AffineMatrix m = matrix;
  for (auto& row : m) {
    const double largest = std::max({std::fabs(row[0]), std::fabs(row[1]), std::fabs(row[2])});
    if (!(largest > 0)) return false;
    const int exponent = std::ilogb(largest);
    for (double& entry : row) entry = std::ldexp(entry, -exponent);
  }
  const auto minor = [&](std::size_t a, std::size_t b) {
    return ExactSum().add_product(m[1][a], m[2][b]).add_product(-m[1][b], m[2][a]);
  };
  const ExactSum determinant =
      ExactSum(m[0][0]) * minor(1, 2) - ExactSum(m[0][1]) * minor(0, 2) + ExactSum(m[0][2]) * minor(0, 1);
  return determinant.sign() < 0;
}

TriangleMesh transformed(TriangleMesh mesh, const Transform& world_from_object) {
  for (Point3& p : mesh.positions) {
    p = world_from_object(p);
    if (!is_finite(p)) throw std::range_error("a vertex is moved out of the range of doubles");
  }
  for (Normal3& n : mesh.normals) n = made_unit(world_from_object(made_unit(n)));
  if (is_mirroring(world_from_object.matrix())) {
    for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  }
  return mesh;
}

Bounds3 bounds_of(const TriangleMesh& mesh, const AffineMatrix& world_from_object) {
  const Transform map(world_from_object);
  Bounds3 bounds;
  for (const Point3& p : mesh.positions) bounds.extend(map(p));
  return bounds;
}

AffineMatrix unit_cube_from(const Bounds3& box) {
  const Vec3 sides = box.max - box.min;
  const double factor = 1 / std::max({sides.x, sides.y, sides.z});
  const auto middle = [&](int axis) { return box.min[axis] / 2 + box.max[axis] / 2; };
  return scaling({factor, factor, factor}) * translation({-middle(0), -middle(1), -middle(2)});
}

}  // namespace plumb
