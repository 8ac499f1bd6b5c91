#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "meshes/formats/write_msh.h"
#include "meshes/generators/icosphere.h"
#include "renderer/accel/triangle_search.h"
#include "renderer/scene_for_tests.h"

namespace plumb {
namespace {

/// A mesh whose numbers are all floats, so that reading it changes none.
OneSurface surface_of(const TriangleMesh& mesh, Accel accel = Accel::bvh8) {
  write_msh(mesh, scene_test_file("mesh.msh"));
  return OneSurface("<surface type='Mesh'><data>mesh.msh</data></surface>",
                    {.overrides = {}, .fresnel = Fresnel::exact, .accel = accel});
}

TriangleMesh quad() {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

TEST(Mesh, FlatNormalIsTheCrossProductOfItsFirstTwoEdges) {
  const OneSurface mesh = surface_of(quad());
  const Ray down{{1.5, 0.5, 3}, {0, 0, -1}};
  EXPECT_EQ(mesh.hit(down)->t, 3);
  EXPECT_EQ(mesh.hit(down)->part, 0u);
  EXPECT_EQ(mesh.normal(down), (Normal3{0, 0, 1}));
  const Ray up{{0.5, 1.5, -3}, {0, 0, 1}};
  EXPECT_EQ(mesh.hit(up)->part, 1u);
  EXPECT_EQ(mesh.normal(up), (Normal3{0, 0, 1})) << "the same from behind";
}

TEST(Mesh, GivenNormalsAreInterpolatedByBarycentricWeights) {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  mesh.normals = {{0, 0, 4}, {4, 0, 0}, {0, 4, 0}};
  const OneSurface surface = surface_of(mesh);
  const Ray ray{{0.25, 0.5, 3}, {0, 0, -1}};
  // Weights 0.25, 0.25, 0.5 of the three.
  EXPECT_EQ(surface->normal(ray, *surface.hit(ray)), (Normal3{1, 2, 1}));
}

TEST(Mesh, TheLowestTriangleWinsATie) {
  TriangleMesh twice = quad();
  twice.triangles = {{0, 2, 3}, {0, 1, 2}, {0, 1, 2}, {1, 2, 0}};
  for (const Accel accel : {Accel::linear, Accel::bvh2, Accel::bvh8}) {
    const OneSurface mesh = surface_of(twice, accel);
    EXPECT_EQ(mesh.hit({{1.5, 0.5, 3}, {0, 0, -1}})->part, 1u);
    EXPECT_EQ(mesh.hit({{1, 1, 3}, {0, 0, -1}})->part, 0u) << "on the shared edge";
  }
}

TEST(Mesh, RangeIsClosedAtBothEnds) {
  const OneSurface mesh = surface_of(quad());
  EXPECT_TRUE(mesh.hit({{1, 0.5, 3}, {0, 0, -1}, 3, 3}));
  EXPECT_TRUE(mesh.blocks({{1, 0.5, 3}, {0, 0, -1}, 0, 3}));
  EXPECT_FALSE(mesh.blocks({{1, 0.5, 3}, {0, 0, -1}, 0, std::nextafter(3, 2)}));
  EXPECT_FALSE(mesh.blocks({{1, 0.5, 3}, {0, 0, -1}, std::nextafter(3, 4), 9}));
}

TEST(Mesh, WithoutTrianglesIsNeverHit) {
  TriangleMesh empty;
  empty.positions = {{0, 0, 0}};
  for (const Accel accel : {Accel::linear, Accel::bvh2, Accel::bvh8}) {
    const OneSurface mesh = surface_of(empty, accel);
    EXPECT_FALSE(mesh.hit({{0, 0, 3}, {0, 0, -1}}));
    EXPECT_TRUE(mesh->bounds().empty());
  }
}

TEST(Mesh, ElementsOfTheSameFileShareOneHierarchy) {
  write_msh(quad(), scene_test_file("mesh.msh"));
  const std::string mesh = "<surface type='Mesh'><data>mesh.msh</data></surface>";
  const ReadScene read = scene_of(mesh + "<surface type='Group'><scale>2 2 2</scale>" + mesh + "</surface>");
  const MeshTable meshes = load_meshes(read.description);
  std::vector<std::string> warnings;
  SurfaceContext context{meshes, Accel::bvh8, warnings};
  const auto kind = std::ranges::find(surface_kinds(), "Mesh", [](const SurfaceKind* each) { return each->kind.name; });
  std::vector<std::unique_ptr<Surface>> made;
  const auto elements = read.description.scene->objects("surface");
  for (const ObjectPointer& element : {elements[0], elements[1]->objects("surface")[0]})
    made.push_back((*kind)->make(*element, context));
  ASSERT_EQ(context.searches.size(), 1u);
  EXPECT_EQ(context.searches.begin()->second.use_count(), 3) << "the table's and the two surfaces'";
  EXPECT_EQ(read.scene.placed().size(), 2u);
}

TEST(Mesh, BoundsLeaveOutVerticesThatNoTriangleUses) {
  TriangleMesh mesh = quad();
  mesh.positions.push_back({100, 100, 100});
  EXPECT_EQ(surface_of(mesh)->bounds(), (Bounds3{{0, 0, 0}, {2, 2, 0}}));
}

TEST(Mesh, RayWithNanHitsNothing) {
  for (const Accel accel : {Accel::linear, Accel::bvh2, Accel::bvh8}) {
    const OneSurface mesh = surface_of(quad(), accel);
    EXPECT_TRUE(mesh.hit({{0.1, 0.2, 5}, {0, 0, -1}}));
    int rays = 0;
    for (const Ray& ray : rays_with_nan()) {
      EXPECT_FALSE(mesh.hit(ray)) << rays;
      ++rays;
    }
    EXPECT_EQ(rays, 8);
  }
}

TEST(Mesh, NothingLeaksOutOfAClosedOneInTheHierarchy) {
  const TriangleMesh sphere = icosphere(3);
  const OneSurface mesh = surface_of(sphere);
  std::mt19937_64 random(23);
  std::uniform_real_distribution<double> u(-1, 1);
  std::uniform_int_distribution<std::size_t> any(0, sphere.positions.size() - 1);
  int rays = 0;
  for (int i = 0; i < 100000; ++i) {
    const Point3 target = sphere.positions[any(random)];
    const Point3 aimed{static_cast<float>(target.x), static_cast<float>(target.y), static_cast<float>(target.z)};
    const Point3 inside{0.5 * u(random), 0.5 * u(random), 0.5 * u(random)};
    ASSERT_TRUE(mesh.hit({inside, aimed - inside})) << "leak, case " << i;
    ++rays;
  }
  EXPECT_EQ(rays, 100000);
}

}  // namespace
}  // namespace plumb
