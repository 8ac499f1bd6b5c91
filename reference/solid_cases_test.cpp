#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "reference/solid_cases_for_tests.h"

namespace plumb {
namespace {

using Random = std::mt19937_64;

double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}
int whole(Random& random, int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); }
double power(Random& random, double low, double high) { return std::pow(10.0, uniform(random, low, high)); }
int sign(Random& random) { return whole(random, 0, 1) == 0 ? -1 : 1; }
/// 0, or +-2^-k: how far a case is moved off its tie.
double nudge(Random& random) {
  return whole(random, 0, 2) == 0 ? 0 : sign(random) * std::ldexp(1, -whole(random, 8, 60));
}

Vec3 unit(Random& random) {
  for (;;) {
    const Vec3 v{uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)};
    if (length(v) > 0.1 && length(v) < 1) return normalized(v);
  }
}
Vec3 whole_vector(Random& random, int size) {
  for (;;) {
    const Vec3 v{1.0 * whole(random, -size, size), 1.0 * whole(random, -size, size), 1.0 * whole(random, -size, size)};
    if (v != Vec3{}) return v;
  }
}
Point3 whole_point(Random& random, int size) { return Point3{} + whole_vector(random, size); }
/// Through `target` (exactly, for small whole numbers), from either hand, or from the target itself.
Ray through(Random& random, const Point3& target, const Vec3& direction) {
  const int steps = whole(random, -3, 3);
  const double low = whole(random, 0, 1) == 0 ? 0 : -Bounds3::kInfinity;
  return {target + static_cast<double>(-steps) * direction, direction, low, Bounds3::kInfinity};
}

Shape sphere(const Point3& center, double radius) {
  return {.kind = ShapeKind::sphere, .center = center, .radius = radius};
}
Shape box(const Point3& low, const Point3& high) { return {.kind = ShapeKind::box, .min = low, .max = high}; }

// Spheres.

SolidCase sphere_far(Random& random) {
  const double r = power(random, -3, 3);
  const Point3 center{uniform(random, -9, 9), uniform(random, -9, 9), uniform(random, -9, 9)};
  const Vec3 away = unit(random);
  const Point3 origin = center + r * power(random, 2, 12) * away;
  const Point3 target = center + r * uniform(random, 0, 1.1) * unit(random);
  return {sphere(center, r), {origin, power(random, -3, 3) * (target - origin)}};
}
SolidCase sphere_huge(Random& random) {
  const double r = power(random, 3, 12);
  const Vec3 up = unit(random);
  const Point3 origin = Point3{} + r * (1 + std::ldexp(1, -whole(random, 10, 56))) * up;
  return {sphere({}, r), {origin, unit(random) - uniform(random, 0, 2) * up}};
}
SolidCase sphere_tangent(Random& random) {
  // (3 k, 4 k) is 5 k from the centre, and (4, -3) is at a right angle to it.
  const double k = whole(random, 1, 50);
  const Point3 center = whole_point(random, 50);
  const Point3 touch = center + Vec3{3 * k, 4 * k, 0};
  const Vec3 along{4.0 * whole(random, 1, 9), 0, 1.0 * whole(random, -9, 9)};
  return {sphere(center, 5 * k * (1 + nudge(random))), through(random, touch, {along.x, -0.75 * along.x, along.z})};
}
SolidCase sphere_on(Random& random) {
  const bool exact = whole(random, 0, 1) == 0;
  const Point3 center = whole_point(random, 50);
  const double r = exact ? 3.0 * whole(random, 1, 20) : power(random, -3, 3);
  const Vec3 out = exact ? (r / 3) * Vec3{1, -2, 2} : r * unit(random);
  return {sphere(center, r), {center + out, exact ? whole_vector(random, 9) : unit(random)}};
}
SolidCase sphere_closest_now(Random& random) {
  // b = 0: the origin is the line's nearest point to the centre.
  const Vec3 d = whole_vector(random, 9);
  const Vec3 out = cross(d, whole_vector(random, 9));
  return {sphere({}, length(out) * uniform(random, 0.5, 3)), {Point3{} + out, d, -9, 9}};
}
SolidCase sphere_point(Random& random) {
  const Point3 center = whole_point(random, 9);
  return {sphere(center, 0), through(random, center + nudge(random) * Vec3{1, 0, 0}, whole_vector(random, 9))};
}

// Boxes.

Shape whole_box(Random& random, bool flat) {
  const Point3 low = whole_point(random, 20);
  Vec3 size{1.0 * whole(random, 1, 9), 1.0 * whole(random, 1, 9), 1.0 * whole(random, 1, 9)};
  for (int axis = 0; axis < 3 && flat; ++axis)
    if (whole(random, 0, 1) == 0) size[axis] = 0;
  return box(low, low + size);
}
/// A corner, a point on an edge or in a face: each coordinate at an end, or (at most `free` of them) somewhere between.
Point3 on_box(Random& random, const Shape& shape, int free) {
  Point3 p;
  for (int axis = 0; axis < 3; ++axis) {
    const bool between = free-- > 0;
    p[axis] = between ? shape.min[axis] + whole(random, 0, 4) * (shape.max[axis] - shape.min[axis]) / 4
              : whole(random, 0, 1) == 0 ? shape.min[axis]
                                         : shape.max[axis];
  }
  return p;
}
SolidCase box_any(Random& random) {
  const Shape shape = whole_box(random, false);
  const Point3 origin{uniform(random, -60, 60), uniform(random, -60, 60), uniform(random, -60, 60)};
  const Point3 target = on_box(random, shape, 3) + uniform(random, 0, 3) * unit(random);
  return {shape, {origin, power(random, -3, 3) * (target - origin)}};
}
SolidCase box_zero(Random& random) {
  const Shape shape = whole_box(random, false);
  Vec3 d = whole_vector(random, 3);
  d[whole(random, 0, 2)] = whole(random, 0, 1) == 0 ? 0.0 : -0.0;
  if (d == Vec3{}) d = {0, -0.0, 1};
  return {shape, through(random, on_box(random, shape, 2), d)};
}
SolidCase box_flat(Random& random) {
  const Shape shape = whole_box(random, true);
  return {shape, through(random, on_box(random, shape, 3), whole_vector(random, 4))};
}
SolidCase box_edge(Random& random) {
  const Shape shape = whole_box(random, whole(random, 0, 3) == 0);
  const Point3 p = on_box(random, shape, whole(random, 0, 1)) + nudge(random) * unit(random);
  return {shape, through(random, p, whole_vector(random, 5))};
}
SolidCase box_edge_rounded(Random& random) {
  const Shape shape = whole_box(random, false);
  const Vec3 d = power(random, -3, 3) * unit(random);
  return {shape, through(random, on_box(random, shape, whole(random, 0, 1)), d)};
}

// Cylinders and cones: the cone's radius is that at its centre, so at z the side is at radius (z - tip) / (center -
// tip).

Shape whole_pillar(Random& random, ShapeKind kind) {
  Shape s{.kind = kind, .center = whole_point(random, 9)};
  s.radius = 5.0 * whole(random, 1, 4);
  s.height = 2.0 * whole(random, 1, 9);
  // In one case of three at an end of the slab, else within or beyond it.
  const double offset = whole(random, 0, 2) == 0 ? s.height / 2 : whole(random, 1, 30);
  s.tip_z = s.center.z + sign(random) * offset;
  return s;
}
double radius_at(const Shape& s, double z) {
  return s.kind == ShapeKind::cylinder ? s.radius : s.radius * (z - s.tip_z) / (s.center.z - s.tip_z);
}
/// On the side at height z: exact where the radius there is five times a small whole number.
Point3 on_side(Random& random, const Shape& s, double z) {
  const double r = radius_at(s, z) * sign(random);
  const Vec3 out = whole(random, 0, 1) == 0 ? Vec3{r, 0, 0} : Vec3{0.6 * r, 0.8 * r, 0};
  return Point3{s.center.x, s.center.y, z} + out;
}
double end_of(Random& random, const Shape& s) { return s.center.z + sign(random) * s.height / 2; }
Vec3 direction(Random& random) {
  return whole(random, 0, 2) == 0 ? power(random, -3, 3) * unit(random) : whole_vector(random, 5);
}

template <ShapeKind kind>
SolidCase pillar_any(Random& random) {
  const Shape s = whole_pillar(random, kind);
  const Point3 origin{uniform(random, -60, 60), uniform(random, -60, 60), uniform(random, -60, 60)};
  const Point3 target = s.center + uniform(random, 0, 25) * unit(random);
  return {s, {origin, power(random, -3, 3) * (target - origin)}};
}
template <ShapeKind kind>
SolidCase pillar_rim(Random& random) {
  const Shape s = whole_pillar(random, kind);
  const Point3 rim = on_side(random, s, end_of(random, s)) + nudge(random) * unit(random);
  return {s, through(random, rim, direction(random))};
}
template <ShapeKind kind>
SolidCase pillar_tilted(Random& random) {
  Shape s = whole_pillar(random, kind);
  if (whole(random, 0, 1) == 0) s.height = power(random, -4, 4);
  const double tilt = whole(random, 0, 3) == 0 ? 0 : sign(random) * power(random, -15, -2);
  const bool upright = whole(random, 0, 1) == 0;
  const Vec3 d = upright ? Vec3{tilt, 0, 1} : Vec3{1.0 * whole(random, -1, 1), 1, tilt};
  return {s, through(random, on_side(random, s, s.center.z + whole(random, -1, 1) * s.height / 2), d)};
}
template <ShapeKind kind>
SolidCase pillar_flat(Random& random) {
  Shape s = whole_pillar(random, kind);
  (whole(random, 0, 2) == 0 ? s.radius : s.height) = 0;
  const Point3 target = whole(random, 0, 1) == 0 ? on_side(random, s, end_of(random, s)) : s.center;
  return {s, through(random, target, direction(random))};
}
template <ShapeKind kind>
SolidCase pillar_on_side(Random& random) {
  const Shape s = whole_pillar(random, kind);
  return {s, through(random, on_side(random, s, s.center.z + whole(random, -4, 4)), direction(random))};
}
/// In the plane that touches the side along a line: at that line, or with it.
template <ShapeKind kind>
SolidCase pillar_tangent(Random& random) {
  const Shape s = whole_pillar(random, kind);
  const double z = s.center.z + whole(random, -4, 4);
  const double r = radius_at(s, z);
  const Vec3 up = kind == ShapeKind::cylinder ? Vec3{0, 0, 1} : Vec3{s.radius, 0, s.center.z - s.tip_z};
  const Vec3 across{0, 1.0 * whole(random, 0, 3), 0};
  Vec3 d = across + static_cast<double>(whole(random, -3, 3)) * up;
  if (d == Vec3{}) d = up;
  return {s, through(random, Point3{s.center.x, s.center.y, z} + Vec3{r * (1 + nudge(random)), 0, 0}, d)};
}
SolidCase cone_tip(Random& random) {
  Shape s = whole_pillar(random, ShapeKind::cone);
  const double off = nudge(random);
  if (whole(random, 0, 1) == 0) s.height = 2 * std::fabs(s.tip_z - s.center.z) * whole(random, 1, 2);
  // Along the side (the line through a point of it), or any way.
  const Point3 tip{s.center.x, s.center.y, s.tip_z};
  const Vec3 d =
      whole(random, 0, 2) == 0 ? on_side(random, s, s.tip_z + 5 * (s.center.z - s.tip_z)) - tip : direction(random);
  return {s, through(random, tip + off * unit(random), d)};
}

template <ShapeKind kind>
void add_pillars(std::vector<SolidFamily>& families) {
  families.insert(families.end(), {{"any", pillar_any<kind>},
                                   {"rim", pillar_rim<kind>},
                                   {"tilted", pillar_tilted<kind>},
                                   {"flat", pillar_flat<kind>},
                                   {"on side", pillar_on_side<kind>},
                                   {"tangent", pillar_tangent<kind>}});
}

}  // namespace

std::vector<SolidFamily> solid_families(ShapeKind kind) {
  std::vector<SolidFamily> families;
  switch (kind) {
    case ShapeKind::sphere:
      return {{"far", sphere_far},      {"huge", sphere_huge},         {"tangent", sphere_tangent},
              {"on sphere", sphere_on}, {"b = 0", sphere_closest_now}, {"point", sphere_point}};
    case ShapeKind::box:
      return {{"any", box_any},
              {"slab zero", box_zero},
              {"flat", box_flat},
              {"edge", box_edge},
              {"edge rounded", box_edge_rounded}};
    case ShapeKind::cone:
      add_pillars<ShapeKind::cone>(families);
      families.push_back({"tip", cone_tip});
      return families;
    default:
      add_pillars<ShapeKind::cylinder>(families);
      return families;
  }
}

std::vector<NamedMatrix> placements() {
  const AffineMatrix turned = rotation_degrees({31, -74, 153});
  return {{"identity", identity_matrix()},
          {"exact shear", AffineMatrix{{{1, 2, 0, 3}, {0, 1, -1, 1}, {0, 0, 1, -7}}}},
          {"exact mirror", AffineMatrix{{{0, -4, 0, 5}, {-1, 0, 0, 2}, {0, 0, -0.5, 1}}}},
          {"rotated", translation({0.1, -7.3, 4}) * turned},
          {"sheared", turned * AffineMatrix{{{1, 0.3, 0, 0.7}, {0, 1.7, -2.1, 0}, {0.9, 0, 1, 0.1}}}},
          {"mirrored", turned * scaling({2, -0.3, 1.1})},
          {"ill-conditioned", turned * scaling({1e6, 1, 1e-6}) * rotation_degrees({12, 25, 38})}};
}

PlacedShape place(const SolidCase& c, const AffineMatrix& matrix) { return {c.shape, matrix}; }

Ray world_ray(const SolidCase& c, const AffineMatrix& matrix) { return Transform(matrix)(c.ray); }

TEST(SolidCases, AreManifoldAndRepeatable) {
  for (const ShapeKind kind : {ShapeKind::sphere, ShapeKind::box, ShapeKind::cylinder, ShapeKind::cone}) {
    for (const SolidFamily& family : solid_families(kind)) {
      Random random(1), again(1);
      std::set<std::string> seen;
      for (int i = 0; i < 100; ++i) {
        const SolidCase c = family.make(random);
        const SolidCase d = family.make(again);
        EXPECT_EQ(c.shape.kind, kind);
        EXPECT_EQ(describe(place(c, identity_matrix()), c.ray), describe(place(d, identity_matrix()), d.ray));
        EXPECT_NE(c.ray.direction, Vec3{}) << family.name;
        seen.insert(describe(place(c, identity_matrix()), c.ray));
      }
      EXPECT_GT(seen.size(), 90U) << family.name;
    }
  }
}

}  // namespace plumb
