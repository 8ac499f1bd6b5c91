#include <gtest/gtest.h>

#include <limits>

#include "meshes/mesh_files_for_tests.h"

namespace plumb {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;
const std::string kFacet =
    "facet normal nan nan nan\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 0\n endloop\nendfacet\n";

std::string refused(const std::string& content) { return refusal("m.stl", content); }

std::string binary(std::uint32_t count, const std::vector<float>& coordinates) {
  std::string content = "solid, though binary";
  content.resize(80);
  content += raw(count);
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    if (i % 9 == 0) content += raw(0.f) + raw(0.f) + raw(0.f);
    content += raw(coordinates[i]);
    if (i % 9 == 8) content += raw(std::uint16_t{0});
  }
  return content;
}

TEST(Stl, JoinsEqualCornersOfText) {
  const TriangleMesh mesh = read_text(
      "m.stl", "solid outer loop\n" + kFacet +
                   "FACET NORMAL 0 0 1 OUTER LOOP VERTEX 1 0 0 vertex 1 1 0.1 vertex 0 1 0 ENDLOOP ENDFACET\nendsolid "
                   "outer loop\nsolid\n" +
                   kFacet + "endsolid\n");
  EXPECT_EQ(mesh.positions, (std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, double(.1f)}}));
  EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {1, 3, 2}, {0, 1, 2}}));
  EXPECT_TRUE(mesh.normals.empty());
}

TEST(Stl, JoinsEqualCornersOfBinary) {
  const TriangleMesh mesh = read_text("m.stl", binary(2, {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}));
  EXPECT_EQ(mesh.positions, (std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
  EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {1, 3, 2}}));
}

TEST(Stl, MayBeEmpty) {
  EXPECT_EQ(read_text("m.stl", "solid\nendsolid"), TriangleMesh{});
  EXPECT_EQ(read_text("m.stl", binary(0, {})), TriangleMesh{});
}

TEST(Stl, KeepsFacetsWithEqualCorners) {
  const TriangleMesh text = read_text(
      "m.stl",
      "solid\n facet normal 0 0 1 outer loop vertex 0 0 1 vertex 1 1 1 vertex 0 -0 1 endloop endfacet endsolid");
  EXPECT_EQ(text.positions, (std::vector<Point3>{{0, 0, 1}, {1, 1, 1}}));
  EXPECT_EQ(text.triangles, (Triangles{{0, 1, 0}}));
  EXPECT_EQ(read_text("m.stl", binary(1, {0, 0, 0, 1, 0, 0, 1, 0, 0})).triangles, (Triangles{{0, 1, 1}}));
}

TEST(Stl, KeepsPointsApartThatAreNotEqual) {
  const TriangleMesh mesh = read_text("m.stl", binary(1, {0, 0, 0, 1, 0, 0, 1, 1e-40f, 0}));
  EXPECT_EQ(mesh.positions, (std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {1, double(1e-40f), 0}}));
}

TEST(Stl, NotesWhatIsLeftOut) {
  MeshNotes notes;
  read_mesh(write_test_file("m.stl", "solid a\n" + kFacet +
                                         "endsolid\nsolid b\nfacet normal 0 0 0 outer loop vertex 0 0 0.12345678901 "
                                         "vertex 1 0 0 vertex 0 1 0 endloop endfacet endsolid\n"),
            &notes);
  EXPECT_EQ(notes.format, "STL, text");
  EXPECT_EQ(notes.sentences,
            (std::vector<std::string>{"6 corners are joined to 4 vertices, those at equal points",
                                      "normals of 1 facet are not kept", "2 solids become one mesh",
                                      "1 number is rounded to single precision, which holds fewer digits"}));
  std::string with_attribute = binary(1, {0, 0, 0, 1, 0, 0, 0, 1, 0});
  with_attribute.back() = '\1';
  read_mesh(write_test_file("m.stl", with_attribute), &notes);
  EXPECT_EQ(notes.format, "STL, binary");
  EXPECT_EQ(notes.sentences, (std::vector<std::string>{"3 corners are joined to 3 vertices, those at equal points",
                                                       "the attribute bytes of 1 facet are not kept"}));
}

TEST(Stl, RefusesAWrongText) {
  EXPECT_EQ(refused(""), "m.stl: neither STL text nor binary STL; expected solid or a header of 84 bytes");
  EXPECT_EQ(refused("solid\n"), "m.stl:2:1: the file ends; expected facet or endsolid");
  EXPECT_EQ(refused("solid\n" + kFacet + "x"), "m.stl:9:1: 'x' stands here; expected facet or endsolid");
  EXPECT_EQ(refused("solid\nendsolid\nx"), "m.stl:3:1: 'x' stands here; expected solid or the end of the file");
  EXPECT_EQ(refused("solid\nfacet normals"), "m.stl:2:7: 'normals' stands here; expected normal");
  EXPECT_EQ(refused("solid\nfacet normal 0 0 1 outer loop\nvertex 0 0 0\nendloop"),
            "m.stl:4:1: 'endloop' stands here; expected vertex");
  EXPECT_EQ(refused("solid\nfacet normal 0 0 1 outer loop\nvertex 0 0"),
            "m.stl:3:11: nothing stands here; expected three coordinates of a corner");
  EXPECT_EQ(refused("solid\nfacet normal 0 0 1 outer loop\nvertex 0 inf 0"),
            "m.stl:3:10: 'inf' is not finite; expected three coordinates of a corner");
}

TEST(Stl, RefusesAWrongBinary) {
  const float infinity = std::numeric_limits<float>::infinity();
  std::string four_billion = binary(4000000000u, {0, 0, 0, 1, 0, 0, 0, 1, 0});
  four_billion[0] = 'x';
  EXPECT_EQ(refused(four_billion),
            "m.stl: 4000000000 facets do not fit the file's 134 bytes; expected 84 and 50 for each facet, or STL text");
  EXPECT_EQ(refused(binary(1, {0, 0, 0, 1, 0, 0, 0, infinity, 0})),
            "m.stl: facet 0: a coordinate is not finite; expected a finite number");
}

}  // namespace
}  // namespace plumb
