#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "meshes/generators/mesh_kind.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

/// What is known of a family's mesh without making it. chi is the Euler characteristic, 2 a ball.
struct Known {
  const char* family;
  std::uint64_t asked, triangles;
  std::int64_t chi;
};

void PrintTo(const Known& known, std::ostream* out) { *out << known.family << " of " << known.asked; }

// The triangles are by the formulas of docs/mesh-tools.md. Genus of the sponges by cutting one into its 20 parts: 5,
// 81, 1409.
const std::vector<Known> kKnown{
    {"icosphere", 1, 20, 2},
    {"icosphere", 100, 320, 2},
    {"icosphere", 5000, 5120, 2},
    {"icosphere", 20480, 20480, 2},
    {"uv_sphere", 1, 8, 2},
    {"uv_sphere", 100, 120, 2},
    {"uv_sphere", 5000, 5040, 2},
    {"uv_sphere", 40000, 40400, 2},
    {"torus_knot", 1, 288, 0},
    {"torus_knot", 1000, 1152, 0},
    {"torus_knot", 5000, 5408, 0},
    {"torus_knot", 40000, 41472, 0},
    {"displaced_sphere", 1, 20, 2},
    {"displaced_sphere", 100, 320, 2},
    {"displaced_sphere", 5000, 5120, 2},
    {"displaced_sphere", 20480, 20480, 2},
    {"terrain", 1, 2, 1},
    {"terrain", 100, 128, 1},
    {"terrain", 5000, 5000, 1},
    {"terrain", 40000, 40328, 1},
    {"lattice_cube", 1, 12, 2},
    {"lattice_cube", 100, 108, 2},
    {"lattice_cube", 5000, 5292, 2},
    {"lattice_cube", 40000, 40368, 2},
    {"needles", 1, 4, 2},
    {"needles", 101, 104, 52},
    {"needles", 5000, 5000, 2500},
    {"needles", 40000, 40000, 20000},
    {"city", 1, 12, 2},
    {"city", 100, 108, 18},
    {"city", 5000, 5004, 834},
    {"city", 40000, 40008, 6668},
    {"menger_sponge", 1, 144, -8},
    {"menger_sponge", 145, 240, -8},
    {"menger_sponge", 1000, 1008, -8},
    {"menger_sponge", 2112, 2112, -160},
    {"menger_sponge", 5000, 5632, -160},
    {"menger_sponge", 36096, 36096, -2816},
    {"nested_shells", 1, 40, 4},
    {"nested_shells", 100, 100, 10},
    {"nested_shells", 5000, 5120, 32},
    {"nested_shells", 40000, 40960, 16},
};

class MeshKinds : public ::testing::TestWithParam<Known> {
 protected:
  const Known known_ = GetParam();
  const MeshKind& kind_ = mesh_kind(known_.family);
  const TriangleMesh mesh_ = kind_.make({known_.asked, 1, {}});
};
INSTANTIATE_TEST_SUITE_P(Sizes, MeshKinds, ::testing::ValuesIn(kKnown));

/// The directed edges as (from, to), in order.
std::vector<std::pair<std::uint32_t, std::uint32_t>> directed_edges(const TriangleMesh& mesh) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) edges.emplace_back(t[i], t[(i + 1) % 3]);
  std::ranges::sort(edges);
  return edges;
}

Vec3 twice_area(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& t) {
  return cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]);
}

/// The pieces that are joined by edges: a number a vertex.
std::vector<std::uint32_t> pieces(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> parent(mesh.positions.size());
  for (std::uint32_t i = 0; i < parent.size(); ++i) parent[i] = i;
  const auto root = [&](std::uint32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (const auto& [a, b, c] : mesh.triangles) {
    parent[root(b)] = root(a);
    parent[root(c)] = root(a);
  }
  for (std::uint32_t i = 0; i < parent.size(); ++i) parent[i] = root(i);
  return parent;
}

TEST_P(MeshKinds, HasTheKnownNumberOfTriangles) {
  EXPECT_EQ(mesh_.triangles.size(), known_.triangles);
  EXPECT_GE(mesh_.triangles.size(), known_.asked);
}

TEST_P(MeshKinds, EdgesJoinTrianglesAsTheyShould) {
  const auto edges = directed_edges(mesh_);
  EXPECT_TRUE(std::ranges::adjacent_find(edges) == edges.end()) << "a directed edge of two triangles";
  std::size_t without_opposite = 0;
  for (const auto& [from, to] : edges) {
    ASSERT_NE(from, to);
    without_opposite += !std::ranges::binary_search(edges, std::pair(to, from));
  }
  if (kind_.closed) {
    EXPECT_EQ(without_opposite, 0);
  } else {
    // Only the terrain is open: its rim has 4 sqrt(triangles / 2) edges.
    EXPECT_EQ(2 * without_opposite * without_opposite, 16 * known_.triangles);
  }
  const auto undirected = static_cast<std::int64_t>((edges.size() + without_opposite) / 2);
  EXPECT_EQ(std::ssize(mesh_.positions) - undirected + std::ssize(mesh_.triangles), known_.chi);
}

TEST_P(MeshKinds, VerticesAreUsedFiniteAndDistinct) {
  std::vector<bool> used(mesh_.positions.size());
  for (const auto& triangle : mesh_.triangles) {
    for (const std::uint32_t corner : triangle) {
      ASSERT_LT(corner, used.size());
      used[corner] = true;
    }
  }
  EXPECT_EQ(std::ranges::count(used, false), 0);
  std::vector<std::tuple<double, double, double>> places;
  for (const Point3& p : mesh_.positions) {
    ASSERT_TRUE(is_finite(p));
    places.emplace_back(p.x, p.y, p.z);
  }
  std::ranges::sort(places);
  EXPECT_TRUE(std::ranges::adjacent_find(places) == places.end()) << "two vertices at one place";
}

TEST_P(MeshKinds, TheFanOfEachVertexIsOne) {
  // Walking from edge to edge around a vertex comes back after as many triangles as it has, where the mesh is closed.
  if (!kind_.closed) {
    EXPECT_EQ(kind_.id, "terrain");
    return;
  }
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> next;  // (vertex, neighbour) -> the next neighbour
  std::vector<std::size_t> around(mesh_.positions.size());
  for (const auto& t : mesh_.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      next[{t[i], t[(i + 1) % 3]}] = t[(i + 2) % 3];
      ++around[t[i]];
    }
  }
  std::uint32_t last = ~0u;
  for (const auto& [edge, unused] : next) {
    const auto [vertex, first] = edge;
    if (vertex == last) continue;
    last = vertex;
    std::size_t steps = 0;
    std::uint32_t neighbour = first;
    do {
      neighbour = next.at({vertex, neighbour});
      ++steps;
    } while (neighbour != first && steps <= around[vertex]);
    ASSERT_EQ(steps, around[vertex]) << "vertex " << vertex;
  }
}

TEST_P(MeshKinds, EachPieceEnclosesAPositiveVolumeOfTrianglesWithAnArea) {
  const std::vector<std::uint32_t> piece = pieces(mesh_);
  std::map<std::uint32_t, double> six_volumes;
  for (const auto& t : mesh_.triangles) {
    const Vec3 area = twice_area(mesh_, t);
    ASSERT_GT(length(area), 0);
    // From a vertex of the piece itself, not from the origin: a small piece far away keeps its sign.
    six_volumes[piece[t[0]]] += dot(area, mesh_.positions[t[0]] - mesh_.positions[piece[t[0]]]);
  }
  if (!kind_.closed) return;
  for (const auto& [first, volume] : six_volumes) ASSERT_GT(volume, 0) << "the piece of vertex " << first;
  // Each piece is a ball but for knot and sponge.
  if (known_.chi > 0) {
    EXPECT_EQ(2 * std::ssize(six_volumes), known_.chi);
  }
}

TEST_P(MeshKinds, NormalsAreUnitAndInFrontOfTheirTriangles) {
  if (mesh_.normals.empty()) {  // its edges are sharp
    EXPECT_THAT(kind_.id, testing::AnyOf("lattice_cube", "needles", "city", "menger_sponge"));
    return;
  }
  ASSERT_EQ(mesh_.normals.size(), mesh_.positions.size());
  // The three roundings of normalizing, or of the product of two sines, are less than 4 ulp.
  for (const Normal3& n : mesh_.normals) ASSERT_NEAR(dot(n, as_vector(n)), 1, 8 * 0x1p-52);
  for (const auto& t : mesh_.triangles) {
    const Vec3 area = twice_area(mesh_, t);
    for (const std::uint32_t corner : t) ASSERT_GT(dot(mesh_.normals[corner], area), 0) << "vertex " << corner;
  }
}

TEST_P(MeshKinds, IsMadeTheSameAgain) {
  EXPECT_EQ(kind_.make({known_.asked, 1, {}}), mesh_);
  EXPECT_EQ(kind_.make({known_.asked, 2, {}}) == mesh_, !kind_.random);
}

TEST_P(MeshKinds, ProgressGoesUpToOne) {
  std::vector<double> shares;
  kind_.make({known_.asked, 1, [&](double share) { shares.push_back(share); }});
  ASSERT_FALSE(shares.empty());
  EXPECT_TRUE(std::ranges::is_sorted(shares));
  EXPECT_GT(shares.front(), 0);
  EXPECT_EQ(shares.back(), 1);
  EXPECT_LE(shares.size(), 300);
}

/// FNV-1a of the numbers of a mesh.
class Hash {
 public:
  explicit Hash(const TriangleMesh& mesh) {
    add(mesh.positions);
    add(mesh.triangles);
    add(mesh.normals);
    add(mesh.texcoords);
  }
  std::string hex() const {
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(state_));
    return digits;
  }

 private:
  template <class Value>
  void add(const std::vector<Value>& values) {
    const auto* const bytes = reinterpret_cast<const unsigned char*>(values.data());
    for (std::size_t i = 0; i < values.size() * sizeof(Value); ++i) state_ = (state_ ^ bytes[i]) * 0x100000001b3u;
  }
  std::uint64_t state_ = 0xcbf29ce484222325u;
};

/// Written down on one machine: others that make another bit fail here.
TEST(MeshKindsBits, AreThoseOfEveryMachine) {
  const std::map<std::string, std::string> golden{
      {"city", "812c09096c1bc24f"},          {"displaced_sphere", "8911b4070a6eed2b"},
      {"icosphere", "4977064ac103e239"},     {"lattice_cube", "fb6179c51cc04761"},
      {"menger_sponge", "c8af62b1495bdebd"}, {"needles", "b11974bd2b4d6a33"},
      {"nested_shells", "3ee66333149f4819"}, {"terrain", "6463b632844bf705"},
      {"torus_knot", "516622216547ae4a"},    {"uv_sphere", "bb791f833c3f6a81"}};
  std::map<std::string, std::string> made;
  for (const MeshKind* kind : mesh_kinds()) made[std::string(kind->id)] = Hash(kind->make({5000, 7, {}})).hex();
  EXPECT_EQ(made, golden);
}

TEST(MeshKindsSizes, AreTheNearestThatAreNotBelow) {
  for (const MeshKind* kind : mesh_kinds()) {
    std::size_t last = 0;
    for (std::uint64_t asked = 1; asked <= 400; ++asked) {
      const std::size_t made = kind->make({asked, 1, {}}).triangles.size();
      ASSERT_GE(made, asked) << kind->id;
      ASSERT_GE(made, last) << kind->id;
      // What is made when asked for it exactly is a number that the family has.
      if (made != last) {
        ASSERT_EQ(kind->make({made, 1, {}}).triangles.size(), made) << kind->id;
      }
      last = made;
    }
  }
}

TEST(MeshKindsSizes, BeyondTheRangeAreRefused) {
  for (const MeshKind* kind : mesh_kinds()) {
    EXPECT_THROW(kind->make({0, 1, {}}), InputError) << kind->id;
    EXPECT_THROW(kind->make({100'000'001, 1, {}}), InputError) << kind->id;
    EXPECT_THROW(kind->make({~std::uint64_t{0}, 1, {}}), InputError) << kind->id;
  }
  for (const char* sphere : {"icosphere", "displaced_sphere"})
    EXPECT_THROW(mesh_kind(sphere).make({20'971'521, 1, {}}), InputError);
}

TEST(MeshKindsSizes, EveryFamilyIsTested) {
  for (const MeshKind* kind : mesh_kinds())
    EXPECT_GE(std::ranges::count(kKnown, kind->id, [](const Known& k) { return std::string_view(k.family); }), 3)
        << kind->id;
  EXPECT_EQ(mesh_kinds().size(), 10);
}

TEST(MeshKindsExtras, AreWhereTheyMakeSense) {
  for (const MeshKind* kind : mesh_kinds()) {
    const TriangleMesh mesh = kind->make({500, 1, {}});
    const bool flat =
        kind->id == "lattice_cube" || kind->id == "needles" || kind->id == "city" || kind->id == "menger_sponge";
    EXPECT_EQ(mesh.normals.empty(), flat) << kind->id;
    EXPECT_EQ(mesh.texcoords.empty(), kind->id != "terrain") << kind->id;
    for (const TexCoord& t : mesh.texcoords) ASSERT_TRUE(t.u >= 0 && t.u <= 1 && t.v >= 0 && t.v <= 1);
  }
}

TEST(MeshKindsExtras, TheCubesCornersAreExactInSinglePrecision) {
  for (const std::uint64_t asked : {12u, 5000u, 40000u}) {
    for (const Point3& p : mesh_kind("lattice_cube").make({asked, 1, {}}).positions) {
      for (int axis = 0; axis < 3; ++axis) ASSERT_EQ(std::ldexp(p[axis], 12), std::floor(std::ldexp(p[axis], 12)));
    }
  }
}

}  // namespace
}  // namespace plumb
