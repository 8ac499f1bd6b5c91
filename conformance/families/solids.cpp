#include "conformance/families/solids.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace plumb {
namespace {

/// A point of the disc of this radius at a height.
Point3 on_disc(Random& random, const Shape& solid, double z, double share) {
  const Vec3 way = random_in_plane(random, 0, 1);
  const Vec3 out = share * radius_at(solid, z) * way;
  return {solid.center.x + out.x, solid.center.y + out.y, z};
}

/// Within this share of the way from the middle to each face.
Point3 in_box(Random& random, const Shape& box, double share) {
  const Point3 middle = middle_of(box);
  const Vec3 half = box.max - middle;
  const Point3 place = random_point(random, -share, share);
  return middle + Vec3{half.x * place.x, half.y * place.y, half.z * place.z};
}

}  // namespace

Shape sphere_of(const Point3& center, double radius) {
  Shape shape;
  shape.kind = ShapeKind::sphere;
  shape.center = center;
  shape.radius = radius;
  return shape;
}

Shape box_of(const Point3& min, const Point3& max) {
  Shape shape;
  shape.kind = ShapeKind::box;
  shape.min = min;
  shape.max = max;
  return shape;
}

Shape cylinder_of(const Point3& center, double radius, double height) {
  Shape shape = sphere_of(center, radius);
  shape.kind = ShapeKind::cylinder;
  shape.height = height;
  return shape;
}

Shape cone_of(const Point3& center, double radius, double height, double tip_z) {
  Shape shape = cylinder_of(center, radius, height);
  shape.kind = ShapeKind::cone;
  shape.tip_z = tip_z;
  return shape;
}

Shape ordinary_sphere(Random& random, const Rounding& rounded) {
  const Point3 center = rounded(random_point(random, -2, 2));
  return sphere_of(center, rounded(random.between(0.25, 2)));
}

Shape ordinary_box(Random& random, const Rounding& rounded) {
  const Point3 middle = random_point(random, -2, 2);
  const Point3 half = random_point(random, 0.25, 1.5);
  return box_of(rounded(middle + -1.0 * from_zero(half)), rounded(middle + from_zero(half)));
}

Shape ordinary_cylinder(Random& random, const Rounding& rounded) {
  const Point3 center = rounded(random_point(random, -2, 2));
  const double radius = rounded(random.between(0.25, 1.5));
  return cylinder_of(center, radius, rounded(random.between(0.5, 3)));
}

Shape ordinary_cone(Random& random, const Rounding& rounded) {
  const Shape body = ordinary_cylinder(random, rounded);
  const double beyond = random.sign() * random.between(0.55, 1.5) * body.height;
  return cone_of(body.center, body.radius, body.height, rounded(body.center.z + beyond));
}

Shape double_cone(Random& random, const Rounding& rounded) {
  const Shape body = ordinary_cylinder(random, rounded);
  const double beyond = random.sign() * random.between(0.15, 0.4) * body.height;
  return cone_of(body.center, body.radius, body.height, rounded(body.center.z + beyond));
}

Point3 middle_of(const Shape& solid) {
  if (solid.kind != ShapeKind::box) return solid.center;
  return solid.min + 0.5 * (solid.max - solid.min);
}

double reach_of(const Shape& solid) {
  if (solid.kind == ShapeKind::sphere) return solid.radius;
  if (solid.kind == ShapeKind::box) return 0.5 * length(solid.max - solid.min);
  const double half = 0.5 * solid.height;
  const double widest = std::max(radius_at(solid, solid.center.z - half), radius_at(solid, solid.center.z + half));
  return std::sqrt(widest * widest + half * half);
}

double radius_at(const Shape& solid, double z) {
  if (solid.kind != ShapeKind::cone) return solid.radius;
  return solid.radius * std::fabs((z - solid.tip_z) / (solid.center.z - solid.tip_z));
}

Point3 inner_point(Random& random, const Shape& solid) {
  if (solid.kind == ShapeKind::box) return in_box(random, solid, 0.8);
  const double share = random.between(0, 0.8);
  if (solid.kind == ShapeKind::sphere) return solid.center + share * solid.radius * random_direction(random);
  double z = solid.center.z + random.between(-0.4, 0.4) * solid.height;
  // Away from the pinch of a double cone, where there is no inside to speak of.
  while (solid.kind == ShapeKind::cone && std::fabs(z - solid.tip_z) < 0.1 * solid.height) {
    z = solid.center.z + random.between(-0.4, 0.4) * solid.height;
  }
  return on_disc(random, solid, z, share);
}

Point3 rim_point(Random& random, const Shape& solid) {
  if (solid.kind == ShapeKind::sphere) return surface_point(random, solid);
  if (solid.kind != ShapeKind::box) {
    return on_disc(random, solid, solid.center.z + random.sign() * 0.5 * solid.height, 1);
  }
  Point3 p = in_box(random, solid, 1);
  const int along = random.integer(0, 2);
  const bool corner = random.one_in(4);
  for (int axis = 0; axis < 3; ++axis) {
    if (axis != along || corner) p[axis] = random.coin() ? solid.min[axis] : solid.max[axis];
  }
  return p;
}

Point3 surface_point(Random& random, const Shape& solid) {
  if (solid.kind == ShapeKind::sphere) return solid.center + solid.radius * random_direction(random);
  if (solid.kind == ShapeKind::box) {
    Point3 p = in_box(random, solid, 1);
    const int axis = random.integer(0, 2);
    p[axis] = random.coin() ? solid.min[axis] : solid.max[axis];
    return p;
  }
  const bool on_cap = random.one_in(3);
  const double z = solid.center.z + (on_cap ? 0.5 * random.sign() : random.between(-0.5, 0.5)) * solid.height;
  return on_disc(random, solid, z, on_cap ? std::sqrt(random.unit()) : 1);
}

Point3 outside_origin(Random& random, const Shape& solid, const Rounding& rounded) {
  const double distance = random.between(2, 4) * reach_of(solid);
  return rounded(middle_of(solid) + distance * random_direction(random));
}

Point3 missed_target(Random& random, const Shape& solid, const Point3& origin) {
  // From 2 reaches away, past 1.6 reaches beside the middle, a line passes it at 1.6 * 2 / sqrt(1.6^2 + 2^2) = 1.25.
  const Vec3 beside = random_perpendicular(random, middle_of(solid) - origin);
  return middle_of(solid) + random.between(1.6, 4) * reach_of(solid) * beside;
}

std::vector<Ray> control_rays(Random& random, const Shape& solid, const Rounding& rounded) {
  std::vector<Ray> rays;
  while (rays.size() < kRaysPerCase) {
    const Point3 origin = outside_origin(random, solid, rounded);
    const Point3 target = random.coin() ? inner_point(random, solid) : missed_target(random, solid, origin);
    rays.push_back(ray_to(origin, target, rounded));
  }
  return rays;
}

FamilyCase solid_case(const Shape& solid, std::vector<Ray> rays, const Rounding& rounded) {
  const double condition = solid_condition(solid, rays, rounded);
  return case_of(solid, std::move(rays), condition);
}

}  // namespace plumb
