#include "meshes/generators/icosphere.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>

namespace plumb {
namespace {

using LongDouble3 = std::array<long double, 3>;

/// |p|^2 in extended precision, whose own error of 2^-63 is far below the 2^-51 that is tested.
long double squared_length(const Point3& p) {
  const LongDouble3 v = {p.x, p.y, p.z};
  return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
}

double volume(const TriangleMesh& mesh) {
  double six_volumes = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Point3 origin;
    six_volumes += dot(mesh.positions[a] - origin, cross(mesh.positions[b] - origin, mesh.positions[c] - origin));
  }
  return six_volumes / 6;
}

class Icosphere : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Subdivisions, Icosphere, ::testing::Range(0, 7));

TEST_P(Icosphere, HasTheCountsOfASphere) {
  const TriangleMesh mesh = icosphere(GetParam());
  const std::size_t faces = 20u << (2 * GetParam());
  EXPECT_EQ(mesh.triangles.size(), faces);
  // Euler: V - E + F = 2 with E = 3F/2.
  EXPECT_EQ(mesh.positions.size(), faces / 2 + 2);
  EXPECT_TRUE(mesh.texcoords.empty());
}

TEST_P(Icosphere, IsClosedAndConsistentlyTurned) {
  const TriangleMesh mesh = icosphere(GetParam());
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> half_edges;
  for (const auto& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) ++half_edges[{t[i], t[(i + 1) % 3]}];
  }
  for (const auto& [edge, times] : half_edges) {
    ASSERT_EQ(times, 1) << edge.first << " -> " << edge.second;
    ASSERT_TRUE(half_edges.contains({edge.second, edge.first})) << edge.first << " -> " << edge.second;
  }
  EXPECT_EQ(half_edges.size(), 3 * mesh.triangles.size());
  EXPECT_EQ(mesh.positions.size() + mesh.triangles.size(), half_edges.size() / 2 + 2);
}

TEST_P(Icosphere, EveryFaceLooksOutward) {
  const TriangleMesh mesh = icosphere(GetParam());
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 normal = cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
    ASSERT_GT(dot(normal, mesh.positions[a] - Point3{}), 0) << a << ' ' << b << ' ' << c;
  }
  // The inscribed icosahedron has the volume 2.536, the ball 4.189; each subdivision comes closer.
  EXPECT_GT(volume(mesh), GetParam() == 0 ? 2.53 : volume(icosphere(GetParam() - 1)));
  EXPECT_LT(volume(mesh), 4.18880);
}

TEST_P(Icosphere, VerticesAreDistinctUnitAndTheirOwnNormals) {
  const TriangleMesh mesh = icosphere(GetParam());
  ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
  std::set<std::tuple<double, double, double>> distinct;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Point3& p = mesh.positions[i];
    // 2 ulp of 1 are 2^-51; the square is off by twice as much.
    ASSERT_LE(std::abs(squared_length(p) - 1), 2 * std::ldexp(1.0L, -51))
        << std::hexfloat << p.x << ' ' << p.y << ' ' << p.z;
    ASSERT_EQ(mesh.normals[i], (Normal3{p.x, p.y, p.z}));
    distinct.insert({p.x, p.y, p.z});
  }
  EXPECT_EQ(distinct.size(), mesh.positions.size());
}

TEST(Icosphere, RefusesMoreSubdivisionsThanItsContract) {
  EXPECT_THROW(icosphere(-1), std::invalid_argument);
  EXPECT_THROW(icosphere(11), std::invalid_argument);
}

}  // namespace
}  // namespace plumb
