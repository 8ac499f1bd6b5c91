#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cstring>
#include <limits>

#include "meshes/generators/icosphere.h"
#include "renderer/accel/bvh8.h"
#include "renderer/accel/searches_for_tests.h"

// What must not change a hit: the instruction set, the number of threads that built, the depth, the frame.

namespace plumb {
namespace {

struct Answer {
  std::optional<SurfaceHit> hit;
  bool any;
  TraceCounters counters;
};

std::vector<Answer> answers(const Bvh8& bvh8, const std::vector<PlacedRay>& rays) {
  std::vector<Answer> all;
  for (const PlacedRay& ray : rays) {
    Answer answer;
    answer.hit = bvh8.closest(ray, answer.counters);
    answer.any = bvh8.any(ray, answer.counters);
    all.push_back(answer);
  }
  return all;
}

std::vector<PlacedRay> placed(const std::vector<Ray>& rays) { return {rays.begin(), rays.end()}; }

TEST(Bvh8, EveryInstructionSetFindsTheSameHits) {
  SearchRandom u(21);
  std::vector<TriangleMesh> meshes{in_single_precision(icosphere(3)),
                                   icosphere(3),
                                   cube_of_squares(-4, 8),
                                   triangle_soup(u, 1000, 0.3),
                                   moved(icosphere(2), 1e-24, {}),
                                   moved(triangle_soup(u, 300, 0.5), 1, {1e5, -1e4, 1e6})};
  const std::vector<std::int64_t> targets = hwy::SupportedAndGeneratedTargets();
  EXPECT_GE(targets.size(), 2u) << "the baseline and this processor's";
  int compared = 0, hits = 0, different = 0;
  std::uint64_t nodes = 0, other_nodes = 0;
  for (const TriangleMesh& mesh : meshes) {
    Bounds3 bounds;
    for (const Point3& p : mesh.positions) bounds.extend(p);
    std::vector<Ray> rays = aimed_rays(mesh, u, 4000, bounds.center(), largest_coordinate(bounds.max - bounds.min));
    for (std::size_t i = 0; i < rays.size(); i += 7) rays[i].direction[static_cast<int>(i % 3)] = u.sign() * 0.0;
    const std::vector<PlacedRay> asked = placed(rays);
    const auto shared = std::make_shared<const TriangleMesh>(mesh);
    const std::vector<Answer> expected = answers(Bvh8(shared), asked);
    for (const std::int64_t target : targets) {
      hwy::GetChosenTarget().Update(target);
      const std::vector<Answer> found = answers(Bvh8(shared), asked);
      hwy::GetChosenTarget().DeInit();
      for (std::size_t i = 0; i < found.size(); ++i, ++compared) {
        hits += found[i].hit.has_value();
        nodes += found[i].counters.node_visits;
        const std::uint64_t a = found[i].counters.node_visits, b = expected[i].counters.node_visits;
        other_nodes += std::max(a, b) - std::min(a, b);
        const bool same = same_hit(found[i].hit, expected[i].hit) && found[i].any == expected[i].any;
        if (!same && ++different == 1)
          ADD_FAILURE() << hwy::TargetName(target) << ": " << shown(rays[i], found[i].hit) << ", else "
                        << shown(rays[i], expected[i].hit);
      }
    }
  }
  EXPECT_EQ(compared, static_cast<int>(6 * 4000 * targets.size()));
  EXPECT_GT(hits, compared / 2);
  EXPECT_EQ(different, 0);
  // Only a fused operation makes a difference, for a box that the ray all but misses.
  EXPECT_LT(other_nodes, nodes / 1000);
}

/// Many parts of a few triangles, so that groups have several.
TriangleMesh scattered(const TriangleMesh& piece, SearchRandom& u, int count) {
  TriangleMesh mesh;
  for (int i = 0; i < count; ++i) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const Vec3 offset = u.vector(10);
    for (const Point3& p : piece.positions) mesh.positions.push_back(p + offset);
    for (const auto& [a, b, c] : piece.triangles) mesh.triangles.push_back({first + a, first + b, first + c});
  }
  return mesh;
}

/// Triangles of the left half with numbers that are none, one of them in seven.
TriangleMesh with_holes(TriangleMesh mesh) {
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 7)
    if (Point3& p = mesh.positions[mesh.triangles[i][0]]; p.x < 0) p.y = std::numeric_limits<double>::quiet_NaN();
  return mesh;
}

/// Every other vertex with its zeros negative.
TriangleMesh with_both_zeros(TriangleMesh mesh) {
  for (std::size_t i = 0; i < mesh.positions.size(); i += 2)
    for (int axis = 0; axis < 3; ++axis)
      if (mesh.positions[i][axis] == 0) mesh.positions[i][axis] = -0.0;
  return mesh;
}

bool same_bits(const Bvh8Tree& a, const Bvh8Tree& b) {
  return a.lines.bytes() == b.lines.bytes() && std::memcmp(a.lines.data(), b.lines.data(), a.lines.bytes()) == 0 &&
         a.triangles.bytes() == b.triangles.bytes() &&
         std::memcmp(a.triangles.data(), b.triangles.data(), a.triangles.bytes()) == 0;
}

TEST(Bvh8, IsTheSameToTheBitWhateverNumberOfThreadsBuiltIt) {
  SearchRandom u(22);
  int compared = 0;
  const TriangleMesh tetrahedron{
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}}, {}, {}};
  // Long ranges of each are cut into slices.
  for (const TriangleMesh& mesh :
       {icosphere(6), triangle_soup(u, 60000, 0.05), with_both_zeros(cube_of_squares(-64, 128)),
        scattered(tetrahedron, u, 20000), with_holes(icosphere(6)), with_holes(triangle_soup(u, 60000, 0.05))}) {
    ASSERT_GT(mesh.triangles.size(), 40000u);
    const auto shared = std::make_shared<const TriangleMesh>(mesh);
    const Bvh8 alone(shared);
    EXPECT_GT(alone.tree().lines.size(), 1000u);
    for (const int threads : {2, 3, 8}) {
      for (int again = 0; again < 3; ++again, ++compared)
        EXPECT_TRUE(same_bits(alone.tree(), Bvh8(shared, {.threads = threads}).tree()))
            << compared << ": " << mesh.triangles.size() << " triangles, " << threads << " threads";
    }
  }
  EXPECT_EQ(compared, 6 * 3 * 3);
}

TEST(Bvh8, OfManySmallPartsOrWithHolesFindsTheSameHits) {
  SearchRandom u(24);
  SearchTally sum;
  const TriangleMesh tetrahedron{
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}}, {}, {}};
  const TriangleMesh whole = icosphere(5);
  for (const TriangleMesh& mesh : {scattered(tetrahedron, u, 1000), with_holes(whole)})
    sum += SearchComparison(mesh)(
        aimed_rays(mesh.triangles.size() == whole.triangles.size() ? whole : mesh, u, 500, {}, 2));
  EXPECT_EQ(sum.rays, 1000);
  EXPECT_GT(sum.hits, 500);
  EXPECT_EQ(sum.different, 0);
}

TEST(Bvh8, FindsTheSameHitsWhereEverySplitPeelsOffATriangle) {
  // Sizes and places that grow make a split by area take a single one off; by 10 each they leave the range of floats,
  // too.
  int meshes = 0;
  for (const double growth : {10.0, 1.25, 1.05}) {
    TriangleMesh mesh;
    std::vector<Ray> rays;
    for (int i = 0; i < 600; ++i) {
      const double x = std::pow(growth, i - 300);
      add_triangle(mesh, {x, -1, -1}, {2 * x, 1, -1}, {x, 0, 1});
      add_triangle(mesh, {-x, -x, 0}, {-2 * x, x, -x}, {-x, 0, x});
      for (const double at : {1.0, 0.75}) {
        if (i % 10 > 0) continue;
        rays.push_back({{at * x, 0.01, 0.1}, {1, 0, 0}});
        rays.push_back({{at * -x, 0.01 * x, 0.1 * x}, {-1, 0, 0}});
        rays.push_back({{at * x, 0.01, 0.1}, {x, 0, 0}, 0, at});
      }
    }
    SearchComparison compare(mesh);
    const SearchTally tally = compare(rays);
    EXPECT_EQ(tally.rays, 360);
    EXPECT_GT(tally.hits, 200) << growth;
    ++meshes;
  }
  EXPECT_EQ(meshes, 3);
}

TEST(Bvh8, FindsTheSameHitsOfPlacedMeshes) {
  SearchRandom u(23);
  SearchTally sum;
  int mirrored = 0, nearest = 0;
  SearchComparison meshes[] = {SearchComparison(in_single_precision(icosphere(2))), SearchComparison(icosphere(2)),
                               SearchComparison(cube_of_squares(-4, 8)), SearchComparison(triangle_soup(u, 300, 0.5)),
                               SearchComparison(moved(icosphere(2), 1, {1e4, 3e3, -1e4}))};
  for (SearchComparison& compare : meshes) {
    const Point3 center = compare.mesh().positions[0].x > 1e3 ? Point3{1e4, 3e3, -1e4} : Point3{};
    for (int i = 0; i < 120; ++i) {
      // Some so that the errors of the rays exceed those of floats.
      const bool is_extreme = i % 12 == 11;
      const double condition = is_extreme ? 1e12 : std::pow(10.0, 6.0 * (i % 4) / 3);
      const double offset = is_extreme ? 1e9 : i % 5 ? std::pow(10.0, 6.0 * (i % 5) / 4) : 0;
      const Transform transform(turned(u, condition, offset));
      const AffineMatrix& m = transform.matrix();
      mirrored += dot(cross(Vec3{m[0][0], m[1][0], m[2][0]}, Vec3{m[0][1], m[1][1], m[2][1]}),
                      Vec3{m[0][2], m[1][2], m[2][2]}) < 0;
      for (const Ray& own : aimed_rays(compare.mesh(), u, is_extreme ? 20 : 100, center, 3)) {
        const Point3 from = transform(own.origin);
        const Ray ray{from, transform(own.at(1)) - from};
        PlacedRay there(ray, transform);
        const auto hit = compare(there);
        if (!hit) continue;
        there.nearest = hit->t + hit->t_error;
        nearest += compare(there).has_value();
      }
    }
    sum += compare.tally();
  }
  EXPECT_EQ(sum.rays - nearest, 5 * (110 * 100 + 10 * 20));
  EXPECT_GT(sum.hits, 55000);
  EXPECT_GT(nearest, 30000);
  EXPECT_GT(mirrored, 200);
  EXPECT_EQ(sum.different, 0);
}

}  // namespace
}  // namespace plumb
