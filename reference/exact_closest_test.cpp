#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "meshes/generators/icosphere.h"
#include "reference/exact_hit.h"
#include "reference/triangle_cases_for_tests.h"

namespace plumb {
namespace {

PlacedShape placed(TriangleMesh mesh) {
  PlacedShape shape;
  shape.shape.kind = ShapeKind::mesh;
  shape.shape.mesh = std::make_shared<const TriangleMesh>(std::move(mesh));
  return shape;
}

/// Two parallel squares of two triangles each, at z = 0 and z = -1; the diagonals run from (0,0) to (4,4).
TriangleMesh squares() {
  return {{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, -1}, {4, 0, -1}, {4, 4, -1}, {0, 4, -1}},
          {{4, 5, 6}, {4, 6, 7}, {0, 1, 2}, {0, 2, 3}},
          {},
          {}};
}

TEST(MeshHit, SortsCrossingsByDepthThenByTriangle) {
  const PlacedShape shape = placed(squares());
  const ExactHit off_diagonal = exact_hit(shape, {{3, 1, 1}, {0, 0, -1}});
  EXPECT_EQ(off_diagonal.hit_class, HitClass::hit);
  ASSERT_EQ(off_diagonal.crossings.size(), 2u);
  EXPECT_EQ(off_diagonal.crossings[0].part, 2u);
  EXPECT_EQ(off_diagonal.crossings[1].part, 0u);
  const ExactHit diagonal = exact_hit(shape, {{1, 1, 1}, {0, 0, -1}});
  EXPECT_EQ(diagonal.hit_class, HitClass::boundary);
  ASSERT_EQ(diagonal.crossings.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_TRUE(diagonal.crossings[i].free);
    EXPECT_EQ(diagonal.crossings[i].part, (std::array<std::uint32_t, 4>{2, 3, 0, 1}[i]));
  }
}

TEST(MeshHit, EqualInexactTsAreEqual) {
  // t = 1/3 through both triangles of a fan, at their common edge and beside it.
  TriangleMesh fan{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {-4, 0, 0}}, {{0, 2, 3}, {0, 1, 2}, {0, 1, 2}}, {}, {}};
  const ExactHit hit = exact_hit(placed(fan), {{0, 1, 1}, {0, 0, -3}});
  ASSERT_EQ(hit.crossings.size(), 3u);
  for (std::uint32_t i = 0; i < 3; ++i) {
    EXPECT_EQ(hit.crossings[i].part, i);
    EXPECT_FALSE(hit.crossings[i].t.exact());
    EXPECT_EQ(hit.crossings[i].t_double, 1.0 / 3);
  }
}

TEST(MeshHit, TellsPlanesCloserThanAnUlpOfT) {
  // At z = 0x1p-80 and 0, seen from z = 1: both t round to the same double, the far one comes first in the list.
  TriangleMesh mesh{{{-1, -1, 0}, {2, -1, 0}, {-1, 2, 0}, {-1, -1, 0x1p-80}, {2, -1, 0x1p-80}, {-1, 2, 0x1p-80}},
                    {{0, 1, 2}, {3, 4, 5}},
                    {},
                    {}};
  const Ray ray{{0, 0, 1}, {0, 0, -3}};
  const ExactHit hit = exact_hit(placed(mesh), ray);
  ASSERT_EQ(hit.crossings.size(), 2u);
  EXPECT_EQ(hit.crossings[0].t, hit.crossings[1].t);
  EXPECT_EQ(hit.crossings[0].part, 1u);
  EXPECT_EQ(hit.crossings[1].part, 0u);

  // The same as two shapes.
  std::vector<PlacedShape> shapes(2);
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t k = 0; k < 3; ++k) shapes[i].shape.vertices[k] = mesh.positions[3 * i + k];
  const ExactClosest closest = exact_closest(shapes, ray);
  ASSERT_EQ(closest.winners.size(), 1u);
  EXPECT_EQ(closest.winners[0].shape, 1u);
}

TEST(MeshHit, EmptyIsAMissAndBadIndicesAreUnsupported) {
  const Ray ray{{0, 0, 1}, {0, 0, -1}};
  EXPECT_EQ(exact_hit(placed({}), ray).hit_class, HitClass::miss);
  PlacedShape none;
  none.shape.kind = ShapeKind::mesh;
  EXPECT_EQ(exact_hit(none, ray).hit_class, HitClass::miss);
  TriangleMesh bad = squares();
  bad.triangles[0][0] = 8;
  EXPECT_EQ(exact_hit(placed(bad), ray).hit_class, HitClass::unsupported);
  bad = squares();
  bad.positions.push_back({std::nan(""), 0, 0});
  EXPECT_EQ(exact_hit(placed(bad), ray).hit_class, HitClass::boundary) << "an unused vertex does not count";
  bad.positions[5].x = std::nan("");
  EXPECT_EQ(exact_hit(placed(bad), ray).hit_class, HitClass::unsupported);
  PlacedShape flat = placed(squares());
  flat.world_from_object = scaling({1, 1, 0});
  EXPECT_EQ(exact_hit(flat, ray).hit_class, HitClass::singular);
}

/// A ray through a closed surface enters as often as it leaves: proper crossings come in pairs where none is free. And
/// the three paths agree on it, placed or not.
TEST(MeshHit, PathsAgreeOnAClosedMeshAndCrossItEvenly) {
  const PlacedShape at_origin = placed(icosphere(1));
  PlacedShape mapped = at_origin;
  mapped.world_from_object = {{{0.5, -1, 0.25, 3}, {1, 0.125, 0, -7}, {0, 0.75, -2, 0.3}}};
  TriangleCases cases(5);
  int crossed = 0, free = 0;
  for (int i = 0; i < 120; ++i) {
    const PlacedShape& shape = i % 2 == 0 ? at_origin : mapped;
    const Vec3 centre = i % 2 == 0 ? Vec3{0, 0, 0} : Vec3{3, -7, 0.3};
    const std::vector<Point3>& positions = shape.shape.mesh->positions;
    const auto vertex = [&] {
      return positions[static_cast<std::size_t>(cases.whole(0, static_cast<int>(positions.size()) - 1))];
    };
    Ray ray{Point3{} + (centre + 8.0 * (vertex() - Point3{})), {}};
    // At a vertex half of the time, where the matrix leaves it exact.
    const Point3 target =
        i % 4 == 0 ? vertex()
                   : Point3{} + (centre + Vec3{cases.uniform(-1, 1), cases.uniform(-1, 1), cases.uniform(-1, 1)});
    ray.direction = target - ray.origin;
    const ExactHit filtered = exact_hit(shape, ray);
    for (const ExactPath path : {ExactPath::polynomial, ExactPath::rational}) {
      const ExactHit other = exact_hit(shape, ray, path);
      ASSERT_EQ(other.hit_class, filtered.hit_class);
      ASSERT_EQ(other.crossings.size(), filtered.crossings.size());
      for (std::size_t k = 0; k < other.crossings.size(); ++k) {
        EXPECT_EQ(other.crossings[k].part, filtered.crossings[k].part);
        EXPECT_EQ(other.crossings[k].t, filtered.crossings[k].t);
        EXPECT_EQ(other.crossings[k].normal, filtered.crossings[k].normal);
      }
    }
    const bool any_free = std::ranges::any_of(filtered.crossings, &ExactCrossing::free);
    free += any_free;
    crossed += filtered.hit_class == HitClass::hit;
    EXPECT_TRUE(any_free || filtered.crossings.size() % 2 == 0) << i;
  }
  EXPECT_GT(crossed, 40);
  EXPECT_GT(free, 0);
}

TEST(ExactClosest, NamesAllWinnersOfATieAndWhatIsFreeBefore) {
  std::vector<PlacedShape> shapes(4);
  const auto set = [&](std::size_t i, double z, double shift) {
    shapes[i].shape.vertices = {Point3{shift, -1, z}, Point3{shift + 4, -1, z}, Point3{shift, 3, z}};
  };
  set(0, 0, -1);    // the tie, at t = 1/3
  set(1, 0.5, 0);   // nearer, and only touched at its edge
  set(2, 0, -0.5);  // the tie
  set(3, -0.5, 0);  // farther, touched
  const Ray ray{{0, 0, 1}, {0, 0, -3}};
  const ExactClosest closest = exact_closest(shapes, ray);
  ASSERT_EQ(closest.winners.size(), 2u);
  EXPECT_EQ(closest.winners[0].shape, 0u);
  EXPECT_EQ(closest.winners[1].shape, 2u);
  ASSERT_EQ(closest.free_nearer.size(), 1u);
  EXPECT_EQ(closest.free_nearer[0].shape, 1u);

  const ExactClosest touched = exact_closest(std::span(shapes).subspan(1, 1), ray);
  EXPECT_TRUE(touched.winners.empty());
  EXPECT_EQ(touched.free_nearer.size(), 1u);
  EXPECT_TRUE(exact_closest({}, ray).winners.empty());
}

/// The winner of a pile of random triangles is the one that a comparison of all t names.
TEST(ExactClosest, IsTheSmallestOfAllCrossings) {
  TriangleCases cases(6);
  int hits = 0;
  for (int i = 0; i < 200; ++i) {
    std::vector<PlacedShape> shapes;
    for (int k = 0; k < 20; ++k) shapes.push_back(cases.next(k % 2 == 0 ? "control" : "sheared").shape());
    const Ray ray = cases.next("control").ray;
    const ExactClosest closest = exact_closest(shapes, ray);
    double nearest = std::numeric_limits<double>::infinity();
    for (const PlacedShape& shape : shapes)
      for (const ExactCrossing& crossing : exact_hit(shape, ray, ExactPath::rational).crossings)
        if (!crossing.free) nearest = std::min(nearest, crossing.t_double);
    ASSERT_EQ(closest.winners.empty(), std::isinf(nearest));
    if (closest.winners.empty()) continue;
    EXPECT_EQ(closest.winners[0].crossing.t_double, nearest);
    ++hits;
  }
  EXPECT_GT(hits, 100);
}

}  // namespace
}  // namespace plumb
