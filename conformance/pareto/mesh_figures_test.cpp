// Escapes and closest surfaces: the counting, on answers made by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "conformance/pareto/closest_figures.h"
#include "conformance/pareto/escape_figures.h"

namespace plumb {
namespace {

SubjectHit hit_of(std::uint32_t primitive, double t) {
  SubjectHit hit;
  hit.surface = 0;
  hit.primitive = primitive;
  hit.t = t;
  return hit;
}

/// In the planes z = 0 (triangles 0 and 1, a square cut from (0,0) to (8,8)) and z = -1 (triangle 2, the same place as
/// 0), and once more in z = 0 (triangle 3, the same as 0: an exact tie).
ClosestScene layers() {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}, {0, 0, -1}, {8, 0, -1}, {8, 8, -1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {0, 1, 2}};
  ClosestScene scene{"layers", {}};
  scene.surface.shape.kind = ShapeKind::mesh;
  scene.surface.shape.mesh = std::make_shared<const TriangleMesh>(std::move(mesh));
  return scene;
}

Ray down_at(double x, double y) { return {{x, y, 2}, {0, 0, -1}}; }

struct Asked {
  Ray ray;
  SubjectHit answer;
};

ClosestFigure judged(const std::vector<Asked>& asked) {
  const ClosestScene scene = layers();
  const PlacedShape shape{scene.surface.shape};
  const Contract contract;
  ClosestTally tally(scene, MeshAim::faces, contract);
  for (const Asked& one : asked) tally.judge(one.ray, exact_closest(std::span(&shape, 1), one.ray), one.answer);
  return std::move(tally).figure();
}

TEST(ClosestTally, EitherOfAnExactTieIsRight) {
  const Ray ray = down_at(6, 2);
  const ClosestFigure figure = judged({{ray, hit_of(0, 2)}, {ray, hit_of(3, 2)}});
  EXPECT_EQ(figure.rays, 2);
  EXPECT_EQ(figure.ties, 2);
  EXPECT_EQ(figure.wrong().count, 0);
}

TEST(ClosestTally, ABoundaryMayBeHitOrNot) {
  const Ray ray = down_at(4, 4);  // on the diagonal of the square, and of the triangle below
  const ClosestFigure figure = judged({{ray, hit_of(0, 2)}, {ray, hit_of(1, 2)}, {ray, hit_of(2, 3)}, {ray, {}}});
  EXPECT_EQ(figure.rays, 4);
  EXPECT_EQ(figure.ties, 4);
  EXPECT_EQ(figure.wrong().count, 0);
}

TEST(ClosestTally, TellsMissedBesideAndBehindApart) {
  const Ray right = down_at(6, 2), left = down_at(2, 6), outside = down_at(9, 2);
  const ClosestFigure figure = judged({{right, {}},
                                       {right, hit_of(1, 2)},
                                       {right, hit_of(2, 3)},
                                       {outside, {}},
                                       {outside, hit_of(0, 2)},
                                       {left, hit_of(1, 2)}});
  EXPECT_EQ(figure.rays, 6);
  EXPECT_EQ(figure.missed, 1);
  EXPECT_EQ(figure.beside, 2);
  EXPECT_EQ(figure.behind, 1);
  EXPECT_EQ(figure.wrong(), (Rate{4, 6}));
  // t = 3 in place of 2, in ulps of 2.
  EXPECT_EQ(figure.farthest_ulps, 0x1p51);
  EXPECT_GT(figure.farthest_u, 0);
}

TEST(ClosestScenes, AreThreeInEitherPrecision) {
  for (const plumb_precision precision : {PLUMB_FLOAT, PLUMB_DOUBLE}) {
    const std::vector<ClosestScene> scenes = closest_scenes(precision);
    ASSERT_EQ(scenes.size(), 3u);
    EXPECT_EQ(scenes[0].surface.shape.mesh->triangles.size(), 320u);
    EXPECT_EQ(scenes[1].surface.shape.mesh->triangles.size(), 768u);
    EXPECT_EQ(scenes[2].surface.shape.mesh->triangles.size(), 640u);
  }
}

TEST(EscapeTally, CountsMissesAndSaysHowFarFromAnEdge) {
  const std::vector<ClosedSurface> meshes = closed_meshes(PLUMB_FLOAT);
  const ClosedSurface& cube = meshes.at(3);
  ASSERT_EQ(cube.name, "cube-1");
  // From the middle of a cube from -8 to 8: through the middle of half a face, through a corner, through a face.
  const std::vector<Ray> rays{{{0, 0, 0}, {2, 1, 8}}, {{0, 0, 0}, {8, 8, 8}}, {{0, 0, 0}, {8, 1, 3}}};
  EscapeTally tally(MeshAim::vertices, PLUMB_FLOAT);
  tally.judge(cube, rays, std::vector<SubjectHit>{{}, {}, hit_of(0, 1)});
  tally.judge(meshes.at(4), rays, std::vector<SubjectHit>{hit_of(0, 1), hit_of(0, 1), hit_of(0, 1)});
  const EscapeFigure figure = std::move(tally).figure();
  EXPECT_EQ(figure.aim, "vertices");
  EXPECT_EQ(figure.meshes, 2);
  EXPECT_EQ(figure.rate(), (Rate{2, 6}));
  EXPECT_EQ(figure.worst_mesh, "cube-1");
  EXPECT_GT(figure.farthest_u, 1e5) << "the first passes far from any edge";
}

TEST(MeshAim, RaysFromInsideStartInsideAndAllAreRepresentable) {
  const Rounding rounded(PLUMB_FLOAT);
  int asked = 0, boundary = 0;
  for (const ClosedSurface& closed : closed_meshes(PLUMB_FLOAT)) {
    const TriangleMesh& mesh = *closed.surface.shape.mesh;
    for (const MeshAim aim : {MeshAim::vertices, MeshAim::edges, MeshAim::faces}) {
      for (const Ray& ray : rays_from_inside(closed.name, mesh, aim, 3, 10, PLUMB_FLOAT)) {
        ++asked;
        EXPECT_EQ(ray.origin, rounded(ray.origin));
        EXPECT_EQ(ray.direction, rounded(ray.direction));
        const ExactHit truth = exact_hit({closed.surface.shape}, ray);
        ASSERT_FALSE(truth.crossings.empty()) << closed.name;
        boundary += truth.crossings.front().free;
        // Through a closed surface to the outside: an odd number of proper crossings, where none is on a boundary.
        int proper = 0, free = 0;
        for (const ExactCrossing& crossing : truth.crossings) ++(crossing.free ? free : proper);
        EXPECT_TRUE(free > 0 || proper % 2 == 1) << closed.name;
      }
    }
  }
  EXPECT_EQ(asked, 14 * 3 * 10);
  // Far from zero numbers have few digits left, and P - o is often exact.
  EXPECT_LT(boundary, asked / 2);
}

TEST(MeshAim, RaysFromOutsideAimedAtFacesMostlyHit) {
  const ClosestScene scene = closest_scenes(PLUMB_FLOAT).at(0);
  int hits = 0;
  const std::vector<Ray> rays =
      rays_from_outside("sphere", *scene.surface.shape.mesh, MeshAim::faces, 1, 100, PLUMB_FLOAT);
  for (const Ray& ray : rays) hits += !exact_hit({scene.surface.shape}, ray).crossings.empty();
  EXPECT_EQ(hits, 100);
}

}  // namespace
}  // namespace plumb
