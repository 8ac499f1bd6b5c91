#include "meshes/formats/mesh_collector.h"

#include <gtest/gtest.h>

#include <limits>

#include "renderer/math/input_error.h"

namespace plumb {
namespace {

using Attributes = MeshCollector::Attributes;
using Face = std::vector<std::uint32_t>;

MeshCollector with_vertices(int count, Attributes attributes = Attributes::kOfVertices) {
  MeshCollector collector("reported.x", attributes);
  for (int i = 0; i < count; ++i) collector.add_vertex({double(i), 0, 0});
  return collector;
}

template <class Call>
std::string refused(Call call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(MeshCollector, FansAFaceAroundItsFirstCorner) {
  MeshCollector collector = with_vertices(5);
  EXPECT_EQ(collector.add_face(Face{4, 0, 1, 2, 3}), 0u);
  EXPECT_EQ(collector.add_face(Face{0, 1, 2}), 1u);
  EXPECT_EQ(collector.faces(), 2u);
  EXPECT_EQ(collector.finish().triangles,
            (std::vector<std::array<std::uint32_t, 3>>{{4, 0, 1}, {4, 1, 2}, {4, 2, 3}, {0, 1, 2}}));
}

TEST(MeshCollector, RefusesWrongReports) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  MeshCollector collector = with_vertices(2);
  EXPECT_EQ(refused([&] {
              collector.add_face(Face{0, 1, 2});
            }),
            "reported.x: face 0 names vertex 2; expected the index of one of 2 vertices");
  EXPECT_EQ(refused([&] {
              collector.add_face(Face{0, 1});
            }),
            "reported.x: face 0 has 2 corners; expected three or more");
  EXPECT_EQ(refused([&] {
              collector.set_position(1, {0, nan, 0});
            }),
            "reported.x: a coordinate of vertex 1 is not finite; expected finite numbers");
  EXPECT_EQ(refused([&] {
              collector.set_normal(0, {nan, 0, 0});
            }),
            "reported.x: the normal of vertex 0 is not finite; expected finite numbers");
  EXPECT_EQ(refused([&] {
              collector.set_texcoord(0, {0, nan});
            }),
            "reported.x: the texture coordinate of vertex 0 is not finite; expected finite numbers");
  EXPECT_EQ(refused([&] { collector.set_normal(0xffffffff, {}); }),
            "reported.x: face 0 names vertex 4294967295; expected the index of one of 2 vertices");
}

TEST(MeshCollector, KeepsExtrasThatEveryVertexHas) {
  MeshCollector collector = with_vertices(2);
  collector.set_normal(1, {0, 0, 2});
  collector.set_normal(0, {0, 0, 1});
  collector.set_texcoord(0, {1, 1});
  const TriangleMesh mesh = collector.finish();
  EXPECT_EQ(mesh.normals, (std::vector<Normal3>{{0, 0, 1}, {0, 0, 2}}));
  EXPECT_TRUE(mesh.texcoords.empty());
}

TEST(MeshCollector, RepeatsAVertexOnceForEachFurtherNormal) {
  MeshCollector collector = with_vertices(4, Attributes::kOfCorners);
  for (const double z : {1.0, 2.0, 1.0, 2.0}) {
    for (std::uint32_t v = 0; v < 3; ++v) collector.set_normal(v, {0, 0, v == 0 ? z : 1});
    collector.add_face(Face{0, 1, 2});
  }
  const TriangleMesh mesh = collector.finish();
  EXPECT_EQ(mesh.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {4, 1, 2}, {0, 1, 2}, {4, 1, 2}}));
  EXPECT_EQ(mesh.positions.size(), 5u);
  EXPECT_EQ(mesh.positions[4], mesh.positions[0]);
  EXPECT_EQ(mesh.normals, (std::vector<Normal3>{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 0}, {0, 0, 2}}));
}

TEST(MeshCollector, DropsExtrasThatSomeCornerLacksAndRepeatsNothingForThem) {
  MeshCollector collector = with_vertices(3, Attributes::kOfCorners);
  collector.set_normal(0, {0, 0, 1});
  collector.add_face(Face{0, 1, 2});
  collector.set_normal(0, {0, 0, 2});
  collector.add_face(Face{0, 1, 2});
  const TriangleMesh mesh = collector.finish();
  EXPECT_EQ(mesh.positions.size(), 3u);
  EXPECT_TRUE(mesh.normals.empty());
}

TEST(MeshCollector, RefusesNormalsOfCornersThatTheFaceLacks) {
  MeshCollector collector = with_vertices(4, Attributes::kOfCorners);
  collector.set_normal(3, {0, 0, 1});
  EXPECT_EQ(refused([&] {
              collector.add_face(Face{0, 1, 2});
            }),
            "reported.x: face 0 has other corners than its normals; expected the same");
}

}  // namespace
}  // namespace plumb
