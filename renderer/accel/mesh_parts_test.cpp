#include "renderer/accel/mesh_parts.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "renderer/accel/binary_tree.h"

namespace plumb {
namespace {

/// The lowest vertex that each is joined to, by sweeps until nothing changes.
std::vector<std::uint32_t> lowest(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> part(mesh.positions.size());
  for (std::uint32_t v = 0; v < part.size(); ++v) part[v] = v;
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& corners : mesh.triangles) {
      const std::uint32_t least = std::min({part[corners[0]], part[corners[1]], part[corners[2]]});
      for (const std::uint32_t v : corners) {
        changed |= part[v] != least;
        part[v] = least;
      }
    }
  }
  return part;
}

/// Triangles among random vertices that are at most `reach` apart in the list.
TriangleMesh random_mesh(std::uint32_t vertices, std::uint32_t triangles, std::uint32_t reach, std::uint32_t seed) {
  std::mt19937 random(seed);
  TriangleMesh mesh;
  mesh.positions.resize(vertices);
  for (std::uint32_t i = 0; i < triangles; ++i) {
    const auto a = static_cast<std::uint32_t>(random() % (vertices - reach));
    mesh.triangles.push_back(
        {a, a + static_cast<std::uint32_t>(random() % reach), a + static_cast<std::uint32_t>(random() % reach)});
  }
  return mesh;
}

TEST(MeshParts, AreThoseOfASweepForAnyNumberOfThreads) {
  int compared = 0, small = 0;
  for (const auto& [triangles, reach] : {std::pair{0U, 2U}, {10'000U, 3U}, {20'000U, 7U}, {60'000U, 40U}}) {
    const TriangleMesh mesh = random_mesh(50'000, triangles, reach, triangles);
    const std::vector<std::uint32_t> expected = lowest(mesh);
    std::map<std::uint32_t, std::uint32_t> vertices;
    for (const std::uint32_t part : expected) ++vertices[part];
    for (const int threads : {1, 2, 8}) {
      WorkerPool pool(threads);
      const MeshParts parts(mesh, pool);
      int different = 0, here = 0;
      for (std::uint32_t v = 0; v < mesh.positions.size(); ++v, ++compared) {
        const bool is_small = vertices[expected[v]] >= 3 && vertices[expected[v]] <= kLeafVertices;
        different += parts.of(v) != expected[v] || parts.is_small(expected[v]) != is_small;
        here += is_small;
      }
      EXPECT_EQ(different, 0) << triangles << " triangles, " << threads << " threads";
      EXPECT_EQ(parts.has_small(), here > 0);
      small += here;
    }
  }
  EXPECT_EQ(compared, 4 * 3 * 50'000);
  EXPECT_GT(small, 10'000);
}

}  // namespace
}  // namespace plumb
