#include "renderer/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "meshes/formats/write_msh.h"
#include "renderer/scene_for_tests.h"

namespace plumb {
namespace {

BuildOptions with(Accel accel) { return {.overrides = {}, .fresnel = Fresnel::exact, .accel = accel}; }

std::optional<Scene::Hit> closest(const Scene& scene, const Ray& ray) {
  TraceCounters counters;
  return scene.closest_hit(ray, counters);
}

TEST(Scene, OfCoincidentSurfacesTheFirstInTheFileIsHit) {
  // The two come third and fourth, behind others that the hierarchy may visit in any order.
  const std::string others =
      "<surface type='Sphere'><center>9 0 0</center></surface><surface type='Sphere'><center>-9 0 0</center></surface>";
  const std::string shapes[] = {"<surface type='Sphere'/>",
                                "<surface type='Box'><minPt>-1 -1 -1</minPt><maxPt>1 1 1</maxPt></surface>",
                                "<surface type='Cylinder'/>", "<surface type='Cone'><tipz>2</tipz></surface>"};
  std::mt19937_64 random(43);
  std::uniform_real_distribution<double> u(-1, 1);
  int hits = 0, misses = 0;
  for (const std::string& shape : shapes) {
    for (const Accel accel : {Accel::linear, Accel::bvh2, Accel::bvh8}) {
      const ReadScene read = scene_of(others + shape + shape + others + shape, with(accel));
      for (int i = 0; i < 2000; ++i) {
        const Point3 from{3 * u(random), 3 * u(random), 3 * u(random)};
        const auto hit = closest(read.scene, {from, Point3{u(random), u(random), u(random)} - from});
        ++(hit ? hits : misses);
        if (!hit) continue;
        EXPECT_TRUE(hit->placed == 2 || std::fabs(read.scene.placed()[hit->placed].surface->bounds().center().x) > 8)
            << shape << i;
      }
    }
  }
  EXPECT_GT(hits, 8000);
  EXPECT_GT(misses, 1000);
}

TEST(Scene, TiesAreDecidedAcrossGroups) {
  // The first lies deep in groups, under transforms that undo each other.
  const std::string first =
      "<surface type='Group'><translate>2 0 0</translate><surface type='Group'><translate>-2 0 0</translate><surface "
      "type='Sphere'/></surface></surface>";
  for (const Accel accel : {Accel::linear, Accel::bvh2, Accel::bvh8}) {
    EXPECT_EQ(
        closest(scene_of(first + "<surface type='Sphere'/>", with(accel)).scene, {{0.5, 0.25, 3}, {0, 0, -1}})->placed,
        0u);
    EXPECT_EQ(
        closest(scene_of("<surface type='Sphere'/>" + first, with(accel)).scene, {{0.5, 0.25, 3}, {0, 0, -1}})->placed,
        0u);
  }
}

std::string number(double x) { return std::to_string(x) + " "; }

/// Many surfaces of every kind, in groups with rotations and uneven scales.
std::string crowd(unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> u(-1, 1);
  const auto triple = [&](double scale) {
    return number(scale * u(random)) + number(scale * u(random)) + number(scale * u(random));
  };
  const auto positive = [&] { return number(0.1 + std::fabs(u(random))); };
  std::string text;
  for (int i = 0; i < 60; ++i) {
    text += "<surface type='Group'><translate>" + triple(6) + "</translate><rotate>" + triple(180) +
            "</rotate><scale>" + positive() + positive() + positive() + "</scale>";
    switch (i % 4) {
      case 0:
        text += "<surface type='Sphere'/>";
        break;
      case 1:
        text += "<surface type='Box'><minPt>-1 -1 -1</minPt><maxPt>1 1 1</maxPt></surface>";
        break;
      case 2:
        text += "<surface type='Cylinder'/>";
        break;
      case 3:
        text += "<surface type='Cone'><tipz>.2</tipz></surface>";
        break;
    }
    text += "</surface>";
  }
  return text;
}

/// One triangle at this height, in single precision.
void write_triangle(const std::string& name, double z) {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, z}, {1, 0, z}, {0, 1, z}};
  mesh.triangles = {{0, 1, 2}};
  write_msh(mesh, scene_test_file(name));
}

TEST(Scene, OfTrianglesWhoseTRoundsAlikeTheExactlyNearerOneIsHit) {
  // From -2^40 the heights 1 and 1 + 2^-23 are at the same rounded t; whichever stands first in the file.
  write_triangle("near.msh", 1);
  write_triangle("far.msh", 1 + 0x1p-23);
  const std::string near = "<surface type='Mesh'><data>near.msh</data></surface>";
  const std::string far = "<surface type='Mesh'><data>far.msh</data></surface>";
  const Ray ray{{0.25, 0.25, -0x1p40}, {0, 0, 3}};
  int scenes = 0;
  for (const Accel accel : {Accel::linear, Accel::bvh2, Accel::bvh8}) {
    for (const bool near_first : {true, false}) {
      const ReadScene read =
          scene_of(near_first ? near + far : far + near, {.overrides = {}, .fresnel = Fresnel::exact, .accel = accel});
      TraceCounters counters;
      EXPECT_EQ(read.scene.closest_hit(ray, counters)->placed, near_first ? 0u : 1u);
      ++scenes;
    }
  }
  EXPECT_EQ(scenes, 6);
}

TEST(Scene, OfATriangleInTheFaceOfABoxTheFirstInTheFileIsHit) {
  write_triangle("face.msh", 1);
  const std::string mesh = "<surface type='Mesh'><data>face.msh</data></surface>";
  const std::string box = "<surface type='Box'><minPt>0 0 1</minPt><maxPt>1 1 2</maxPt></surface>";
  int rays = 0;
  for (const bool mesh_first : {true, false}) {
    const ReadScene read = scene_of(mesh_first ? mesh + box : box + mesh);
    for (int i = 1; i < 200; ++i, ++rays) {
      // The exact t is 3 / i, mostly no double; that of the box is rounded.
      const Ray ray{{0.25, 0.25, -2}, {0, 0, static_cast<double>(i)}};
      TraceCounters counters;
      EXPECT_EQ(read.scene.closest_hit(ray, counters)->placed, 0u) << i;
    }
  }
  EXPECT_EQ(rays, 398);
}

TEST(Scene, HierarchyFindsTheSameHitsAsLinearSearch) {
  int hits = 0, misses = 0, blocked = 0;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const ReadScene linear = scene_of(crowd(seed), with(Accel::linear));
    const ReadScene bvh2 = scene_of(crowd(seed), with(Accel::bvh2));
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> u(-1, 1);
    for (int i = 0; i < 2000; ++i) {
      const Point3 from{9 * u(random), 9 * u(random), 9 * u(random)};
      const Ray ray{from, Point3{6 * u(random), 6 * u(random), 6 * u(random)} - from, 1e-6, i % 2 ? 1.0 : 1e9};
      TraceCounters counters;
      const auto a = closest(linear.scene, ray);
      const auto b = closest(bvh2.scene, ray);
      ASSERT_EQ(a.has_value(), b.has_value()) << seed << " " << i;
      EXPECT_EQ(linear.scene.blocks(ray, counters), a.has_value());
      EXPECT_EQ(bvh2.scene.blocks(ray, counters), a.has_value());
      ++(a ? hits : misses);
      if (!a) continue;
      EXPECT_EQ(a->placed, b->placed) << seed << " " << i;
      EXPECT_EQ(a->hit.part, b->hit.part);
      EXPECT_TRUE(same_bits(a->hit.t, b->hit.t));
      blocked += i % 2;
    }
  }
  EXPECT_GT(hits, 2000);
  EXPECT_GT(misses, 1000);
  EXPECT_GT(blocked, 500);
}

TEST(Scene, ShadingPointIsInWorldSpaceWithUnitVectors) {
  // The sphere x^2/4 + y^2 + z^2 = 1 at (sqrt 2, sqrt(1/2), 0) has the gradient (2 x / 4, 2 y, 0), along (1, 2, 0).
  const ReadScene read = scene_of("<surface type='Group'><scale>2 1 1</scale><surface type='Sphere'/></surface>");
  const double root_half = std::sqrt(0.5);
  const Ray ray{{2 * root_half, 5, 0}, {0, -3, 0}};
  const auto hit = closest(read.scene, ray);
  ASSERT_TRUE(hit);
  // Near the hit the root is the square root of 1/2, known to a few units of 2^-53: 1e-15.
  EXPECT_NEAR(hit->hit.t, (5 - root_half) / 3, 1e-15);
  const ShadingPoint point = read.scene.shading_point(ray, *hit);
  EXPECT_NEAR(point.position.y, root_half, 2e-15);
  EXPECT_NEAR(point.normal.x, 1 / std::sqrt(5.0), 2e-15);
  EXPECT_NEAR(point.normal.y, 2 / std::sqrt(5.0), 2e-15);
  EXPECT_EQ(point.to_viewer, (Vec3{0, 1, 0}));
}

TEST(Scene, MirroredSurfacesKeepTheirOutwardNormals) {
  const ReadScene read = scene_of("<surface type='Group'><scale>-1 2 1</scale><surface type='Sphere'/></surface>");
  const Ray ray{{5, 0, 0}, {-1, 0, 0}};
  EXPECT_EQ(read.scene.shading_point(ray, *closest(read.scene, ray)).normal, (Normal3{1, 0, 0}));
}

TEST(Scene, WithoutSurfacesIsEmpty) {
  TraceCounters counters;
  for (const Accel accel : {Accel::linear, Accel::bvh2, Accel::bvh8}) {
    const ReadScene read = scene_of("", with(accel));
    EXPECT_FALSE(closest(read.scene, {{0, 0, 0}, {0, 0, 1}}));
    EXPECT_FALSE(read.scene.blocks({{0, 0, 0}, {0, 0, 1}}, counters));
  }
}

}  // namespace
}  // namespace plumb
