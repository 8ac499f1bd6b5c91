#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

#include "meshes/formats/write_msh.h"
#include "meshes/generators/icosphere.h"
#include "renderer/math/rotation.h"
#include "renderer/scene_for_tests.h"

// Rays in closed surfaces under nested, sheared and mirrored transforms: none escapes, and both ways to search find the
// same hits.

namespace plumb {
namespace {

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double operator()() { return uniform_(engine_); }
  Vec3 vector(double size) { return {size * (*this)(), size * (*this)(), size * (*this)()}; }
  std::size_t below(std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(engine_); }

 private:
  std::mt19937_64 engine_;
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

std::string numbers(const Vec3& v) {
  std::ostringstream text;
  text.precision(17);
  text << v.x << " " << v.y << " " << v.z;
  return text.str();
}

/// The surface within `depth` groups of a translation, a rotation and scales of either sign each. Scales that are not
/// uniform shear what is turned within them. The product of all has a condition up to condition^(1/2) squared.
std::string nested(const std::string& surface, int depth, double condition, Random& u) {
  const double reach = 0.5 * std::log(condition) / depth;
  std::string text = surface;
  for (int i = 0; i < depth; ++i) {
    Vec3 factors;
    for (int axis = 0; axis < 3; ++axis) factors[axis] = std::copysign(std::exp(reach * u()), u());
    text = "<surface type='Group'><translate>" + numbers(u.vector(1)) + "</translate><rotate>" +
           numbers(u.vector(180)) + "</rotate><scale>" + numbers(factors) + "</scale>" + text + "</surface>";
  }
  return text;
}

/// A closed surface around the origin, with points on it that are hard to hit, and a radius within which all is inside.
struct Closed {
  std::string element;
  std::vector<Point3> targets;
  double inner;
};

Closed closed_mesh(const TriangleMesh& mesh, const std::string& name, double inner) {
  write_msh(mesh, scene_test_file(name));
  Closed closed{"<surface type='Mesh'><data>" + name + "</data></surface>", {}, inner};
  for (const auto& triangle : mesh.triangles) {
    const Point3& a = mesh.positions[triangle[0]];
    const Point3& b = mesh.positions[triangle[1]];
    const Point3& c = mesh.positions[triangle[2]];
    closed.targets.push_back(a);
    closed.targets.push_back(a + 0.5 * (b - a));
    closed.targets.push_back(b + 0.3 * (c - b));
  }
  return closed;
}

/// The surface of the cube [-n, n]^3 out of unit squares.
TriangleMesh lattice_cube(int n) {
  TriangleMesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {-n, n}) {
      for (int i = -n; i < n; ++i) {
        for (int k = -n; k < n; ++k) {
          const auto first = static_cast<std::uint32_t>(mesh.positions.size());
          for (const auto& [di, dk] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
            Point3 p;
            p[axis] = side;
            p[(axis + 1) % 3] = i + di;
            p[(axis + 2) % 3] = k + dk;
            mesh.positions.push_back(p);
          }
          mesh.triangles.push_back({first, first + 1, first + 2});
          mesh.triangles.push_back({first, first + 2, first + 3});
        }
      }
    }
  }
  return mesh;
}

/// Points at the rims of a solid of revolution between two heights.
std::vector<Point3> rims(double bottom, double bottom_radius, double top, double top_radius) {
  std::vector<Point3> points;
  for (int i = 0; i < 64; ++i) {
    const auto [cos, sin] = cos_sin_degrees(5.7 * i);
    points.push_back({bottom_radius * cos, bottom_radius * sin, bottom});
    points.push_back({top_radius * cos, top_radius * sin, top});
  }
  return points;
}

Closed ball() {
  return {"<surface type='Sphere'><radius>1.5</radius></surface>", {{1.5, 0, 0}, {0, -1.5, 0}, {0, 0, 1.5}}, 0.8};
}
Closed box() {
  const Bounds3 bounds{{-1, -0.75, -1.25}, {1, 1.25, 0.75}};
  Closed closed{"<surface type='Box'><minPt>-1 -.75 -1.25</minPt><maxPt>1 1.25 .75</maxPt></surface>", {}, 0.4};
  for (int i = 0; i < 8; ++i) {
    closed.targets.push_back(bounds.corner(i));
    closed.targets.push_back(bounds.corner(i) + 0.5 * (bounds.corner(i ^ 1) - bounds.corner(i)));
  }
  return closed;
}
Closed cylinder() {
  return {"<surface type='Cylinder'><radius>1.25</radius><height>1.5</height></surface>", rims(-0.75, 1.25, 0.75, 1.25),
          0.4};
}
Closed cone() {
  // Radius 1 at z = 0 and tip at z = 2: 1.375 at the bottom, 0.625 at the top.
  return {"<surface type='Cone'><radius>1</radius><tipz>2</tipz><height>1.5</height></surface>",
          rims(-0.75, 1.375, 0.75, 0.625), 0.35};
}

struct Figures {
  int rays = 0, escapes = 0, different = 0, mirrored = 0;
};

bool same_hit(const std::optional<Scene::Hit>& a, const std::optional<Scene::Hit>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return a->placed == b->placed && a->hit.part == b->hit.part && same_bits(a->hit.t, b->hit.t);
}

std::string shown(const Ray& ray) {
  std::ostringstream text;
  text << std::hexfloat << "ray from " << ray.origin.x << " " << ray.origin.y << " " << ray.origin.z << " along "
       << ray.direction.x << " " << ray.direction.y << " " << ray.direction.z;
  return text.str();
}

/// Two of the surface, each under transforms of its own, so that the top of the hierarchy has something to choose.
Figures shoot(const Closed& closed, int scenes, int rays, double condition, unsigned seed) {
  Random u(seed);
  Figures figures;
  TraceCounters counters;
  for (int s = 0; s < scenes; ++s) {
    const int depth = 1 + s % 8;
    const std::string text =
        nested(closed.element, depth, condition, u) + nested(closed.element, 9 - depth, condition, u);
    const auto build = [&](Accel accel) {
      return scene_of(text, {.overrides = {}, .fresnel = Fresnel::exact, .accel = accel});
    };
    const ReadScene linear = build(Accel::linear), bvh2 = build(Accel::bvh2), bvh8 = build(Accel::bvh8);
    for (int i = 0; i < rays; ++i) {
      const Transform& world_from_object = linear.scene.placed()[i % 2].world_from_object;
      const auto& m = world_from_object.matrix();
      figures.mirrored += dot(cross(Vec3{m[0][0], m[1][0], m[2][0]}, Vec3{m[0][1], m[1][1], m[2][1]}),
                              Vec3{m[0][2], m[1][2], m[2][2]}) < 0;
      const Point3 inside = Point3{} + u.vector(closed.inner);
      const Point3 target = i % 4 == 0 ? inside + u.vector(1) : closed.targets[u.below(closed.targets.size())];
      const Point3 from = world_from_object(inside);
      const Ray ray{from, world_from_object(target) - from};
      const auto found = bvh8.scene.closest_hit(ray, counters);
      figures.escapes += !found.has_value();
      if (figures.escapes == 1 && !found) ADD_FAILURE() << "scene " << s << ", first escape: " << shown(ray);
      // From outside and past it too.
      const Ray back{ray.at(1.5), -1.0 * ray.direction};
      for (const Ray& each : {ray, back}) {
        const auto hit = linear.scene.closest_hit(each, counters);
        const bool same = same_hit(hit, bvh2.scene.closest_hit(each, counters)) &&
                          same_hit(hit, bvh8.scene.closest_hit(each, counters));
        figures.different += !same;
        if (figures.different == 1 && !same) ADD_FAILURE() << "scene " << s << ", first difference: " << shown(each);
      }
      ++figures.rays;
    }
  }
  EXPECT_EQ(figures.escapes, 0);
  EXPECT_EQ(figures.different, 0);
  EXPECT_GT(figures.mirrored, figures.rays / 4);
  return figures;
}

// In the object's frame a ray is off by some u times the condition, which stays far below the distance from the inner
// points to the surface.

TEST(Robustness, NoRayEscapesFromASphere) { EXPECT_EQ(shoot(ball(), 50, 5000, 1e6, 1).rays, 250000); }
TEST(Robustness, NoRayEscapesFromABox) { EXPECT_EQ(shoot(box(), 50, 5000, 1e6, 2).rays, 250000); }
TEST(Robustness, NoRayEscapesFromACylinder) { EXPECT_EQ(shoot(cylinder(), 50, 5000, 1e6, 3).rays, 250000); }
TEST(Robustness, NoRayEscapesFromACone) { EXPECT_EQ(shoot(cone(), 50, 5000, 1e6, 4).rays, 250000); }
TEST(Robustness, NoRayEscapesFromALatticeCube) {
  EXPECT_EQ(shoot(closed_mesh(lattice_cube(2), "lattice.msh", 1.5), 16, 4000, 1e6, 5).rays, 64000);
}
TEST(Robustness, NoRayEscapesFromAnIcosphere) {
  EXPECT_EQ(shoot(closed_mesh(in_single_precision(icosphere(2)), "ico2.msh", 0.5), 16, 3000, 1e6, 6).rays, 48000);
}

TEST(Robustness, BothSearchesAgreeUnderIllConditionedTransforms) {
  // At condition 1e12 the object's frame keeps few digits of a ray, so that one which passes beside the box hits all
  // the same; the hierarchy must leave room for that. The rays lie in the planes of a box's faces, or beside them by up
  // to a ten-thousandth.
  Random u(7);
  TraceCounters counters;
  int rays = 0, hits = 0, different = 0;
  for (int s = 0; s < 200; ++s) {
    const std::string text =
        nested(s % 2 ? "<surface type='Sphere'/>" : "<surface type='Cylinder'/>", 1 + s % 8, 1e12, u);
    const auto build = [&](Accel accel) {
      return scene_of(text, {.overrides = {}, .fresnel = Fresnel::exact, .accel = accel});
    };
    const ReadScene linear = build(Accel::linear), bvh2 = build(Accel::bvh2);
    const PlacedSurface& placed = linear.scene.placed()[0];
    const Bounds3 bounds = placed.surface->world_bounds(placed.world_from_object);
    const Vec3 extent = 0.5 * (bounds.max - bounds.min);
    for (int i = 0; i < 300; ++i, ++rays) {
      const int axis = i % 3;
      // Where the body touches its highest face: along the row of the matrix, in object space.
      const auto& row = placed.world_from_object.matrix()[static_cast<std::size_t>(axis)];
      const Vec3 up = normalized(Vec3{row[0], row[1], s % 2 ? row[2] : 0});
      Point3 touch = placed.world_from_object(Point3{up.x, up.y, s % 2 ? up.z : std::copysign(0.5, row[2])});
      touch[axis] = bounds.max[axis] + extent[axis] * std::pow(10, -10 + 5 * u());
      Vec3 along{extent.x * u(), extent.y * u(), extent.z * u()};
      along[axis] = 0;
      const Ray ray{touch + -3.0 * along, along};
      const auto hit = linear.scene.closest_hit(ray, counters);
      hits += hit.has_value();
      const bool same = same_hit(hit, bvh2.scene.closest_hit(ray, counters));
      different += !same;
      if (different == 1 && !same) ADD_FAILURE() << "scene " << s << ", first difference: " << shown(ray);
    }
  }
  EXPECT_EQ(different, 0);
  EXPECT_EQ(rays, 60000);
  EXPECT_GT(hits, 1000) << "rays beside the box that hit by their rounding";
}

}  // namespace
}  // namespace plumb
