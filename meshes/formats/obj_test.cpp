#include <gtest/gtest.h>

#include "meshes/mesh_files_for_tests.h"

namespace plumb {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;
const std::string kQuad = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

std::string refused(const std::string& content) { return refusal("m.obj", content); }

TEST(Obj, ReadsFacesInEveryNotation) {
  const TriangleMesh mesh = read_text(
      "m.obj", "# a comment\no thing\n" + kQuad +
                   "vt 0 0\nvn 0 0 1\r\n"
                   "f 1 2 3\n  f\t1/1 2/1 3/1 # behind\nf 1//1 2//1 3//1\nf 1/1/1 2/1/1 3/1/1\nf -4 -3 -2\ns off");
  EXPECT_EQ(mesh.triangles, Triangles(5, {0, 1, 2}));
  EXPECT_EQ(mesh.positions, (std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
  EXPECT_TRUE(mesh.normals.empty());  // not every corner has one
  EXPECT_TRUE(mesh.texcoords.empty());
}

TEST(Obj, FansFacesAndKeepsNonManifoldOnes) {
  const TriangleMesh mesh = read_text("m.obj", kQuad + "v 0 0 1\nf 1 2 3 4\nf 1 3 5\nf 3 1 5\nf 1 3 2\nf 1 2 3\n");
  EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}, {0, 2, 4}, {2, 0, 4}, {0, 2, 1}, {0, 1, 2}}));
  EXPECT_EQ(mesh.positions.size(), 5u);
}

TEST(Obj, AFaceMayNameVerticesThatFollow) {
  EXPECT_EQ(read_text("m.obj", "f 1 2 3\n" + kQuad).triangles, (Triangles{{0, 1, 2}}));
  EXPECT_EQ(read_text("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 9 9 9\nf -3 -2 -1").triangles,
            (Triangles{{0, 1, 2}, {1, 2, 3}}));
}

TEST(Obj, KeepsSharedNormalsAndTexcoordsWithoutRepeatingVertices) {
  const TriangleMesh mesh = read_text(
      "m.obj",
      kQuad + "vn 0 0 1\nvn 0 0 1\nvt 0 0 0.5\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1/1 2/2/1 3/3/1\nf 1/1/2 3/3/2 4/4/2\n");
  EXPECT_EQ(mesh.positions.size(), 4u);
  EXPECT_EQ(mesh.normals, std::vector<Normal3>(4, {0, 0, 1}));
  EXPECT_EQ(mesh.texcoords, (std::vector<TexCoord>{{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
}

TEST(Obj, RepeatsAVertexWhoseCornersDisagree) {
  const TriangleMesh mesh =
      read_text("m.obj", kQuad + "v 7 7 7\nvn 0 0 1\nvn 0 1 0\nf 1//1 2//1 3//1\nf 1//2 3//1 4//2\n");
  EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {5, 2, 3}}));
  EXPECT_EQ(mesh.positions[5], mesh.positions[0]);
  EXPECT_EQ(mesh.normals, (std::vector<Normal3>{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 1, 0}, {0, 0, 0}, {0, 1, 0}}));
}

TEST(Obj, NeedsNoFaces) {
  EXPECT_EQ(read_text("m.obj", ""), TriangleMesh{});
  EXPECT_EQ(read_text("m.obj", kQuad + "vn 0 0 1\nvn 0 0 1\nvn 0 0 1\nvn 0 0 1\n").positions.size(), 4u);
}

TEST(Obj, OpensNoOtherFileAndPrintsNothing) {
  ::testing::internal::CaptureStderr();
  ::testing::internal::CaptureStdout();
  // Reading a device without an end would never return.
  EXPECT_EQ(read_text("m.obj", "mtllib /dev/zero\nusemtl no such\n" + kQuad + "f 1 2 3\n").triangles.size(), 1u);
  EXPECT_EQ(::testing::internal::GetCapturedStderr() + ::testing::internal::GetCapturedStdout(), "");
}

TEST(Obj, RefusesWrongNumbers) {
  const std::string coordinates = "; expected three coordinates of a vertex";
  EXPECT_EQ(refused("v 0 0\n"), "m.obj:1:6: nothing stands here" + coordinates);
  EXPECT_EQ(refused("v 0 0 x\n"), "m.obj:1:7: 'x' is not a number" + coordinates);
  EXPECT_EQ(refused("v 0 0 nan"), "m.obj:1:7: 'nan' is not finite" + coordinates);
  EXPECT_EQ(refused("v 0 1e39 0"), "m.obj:1:5: '1e39' does not fit single precision" + coordinates);
  EXPECT_EQ(refused("v 0 0 0 y"), "m.obj:1:9: 'y' is not a number" + coordinates);
  EXPECT_EQ(refused("\nvn 0 0"), "m.obj:2:7: nothing stands here; expected three numbers of a normal");
  EXPECT_EQ(refused("vt 0"), "m.obj:1:5: nothing stands here; expected two numbers of a texture coordinate");
}

TEST(Obj, RefusesWrongIndices) {
  const std::string one_of_four = "; expected the index of a vertex, of which there are 4";
  EXPECT_EQ(refused(kQuad + "f 1 2 5"), "m.obj:5:7: '5' is out of range" + one_of_four);
  EXPECT_EQ(refused(kQuad + "f 0 1 2"), "m.obj:5:3: '0' is out of range" + one_of_four);
  EXPECT_EQ(refused(kQuad + "f 1 2 -5"), "m.obj:5:7: '-5' is out of range" + one_of_four);
  EXPECT_EQ(refused(kQuad + "f 1 2 99999999999999999999"),
            "m.obj:5:7: '99999999999999999999' is out of range" + one_of_four);
  EXPECT_EQ(refused(kQuad + "f 1 2 three"), "m.obj:5:7: 'three' is not a whole number" + one_of_four);
  EXPECT_EQ(refused(kQuad + "f 1 2 3//1"),
            "m.obj:5:10: '1' is out of range; expected the index of a normal, of which there are 0");
  EXPECT_EQ(refused(kQuad + "f 1 2 3/2"),
            "m.obj:5:9: '2' is out of range; expected the index of a texture coordinate, of which there are 0");
}

// A corner without a vertex makes OpenMesh's assertion stop the program; it passes over a fourth part, and
// drops a repeated vertex and with it, sometimes, the face.
TEST(Obj, RefusesFacesThatOpenMeshWouldMisread) {
  EXPECT_EQ(refused(kQuad + "f /1 2 3"),
            "m.obj:5:3: the corner '/1' has no vertex; expected v, v/vt, v//vn or v/vt/vn");
  EXPECT_EQ(refused(kQuad + "f 1 2 3/"),
            "m.obj:5:9: the corner '3/' has no texture coordinate; expected v, v/vt, v//vn or v/vt/vn");
  EXPECT_EQ(refused(kQuad + "vn 0 0 1\nvt 0 0\nf 1 2 3/1/1/1"),
            "m.obj:7:7: the corner '3/1/1/1' has more than three parts; expected v, v/vt, v//vn or v/vt/vn");
  EXPECT_EQ(refused(kQuad + "f 1 2"), "m.obj:5:1: a face of 2 corners; expected three or more");
  EXPECT_EQ(refused(kQuad + "f"), "m.obj:5:1: a face of 0 corners; expected three or more");
}

TEST(Obj, KeepsFacesThatHaveAVertexTwice) {
  const TriangleMesh mesh =
      read_text("m.obj", kQuad + "vn 0 0 1\nvn 0 1 0\nf 1//1 1//1 2//1\nf 3//1 4//2 3//2\nf 4//2 4//2 4//2\n");
  EXPECT_EQ(mesh.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 0, 1}, {2, 3, 4}, {3, 3, 3}}));
  EXPECT_EQ(mesh.positions.size(), 5u);
  EXPECT_EQ(mesh.positions[4], mesh.positions[2]);
  EXPECT_EQ(mesh.normals, (std::vector<Normal3>{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 1, 0}, {0, 1, 0}}));
}

TEST(Obj, NotesWhatIsLeftOut) {
  MeshNotes notes;
  read_mesh(write_test_file(
                "m.obj",
                "mtllib a.mtl\nv 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 1 1 0.12345678901\nv 0 1 0\nvt 0 0 0\nvn 0 0 1\nvn "
                "0 1 0\ng a\nusemtl b\nf 1/1/1 2/1/1 3/1/1 4/1/1\nusemtl c\nf 1/1 2/1 3/1 # no\n"),
            &notes);
  EXPECT_EQ(notes.format, "OBJ, text");
  EXPECT_EQ(notes.polygons, 1u);
  EXPECT_EQ(notes.sentences,
            (std::vector<std::string>{
                "statements that are not kept: 1 'g', 1 'mtllib', 2 'usemtl'",
                "colours or weights of 2 vertices are not kept", "the third number of 1 texture coordinate is not kept",
                "normals are not kept, because only 4 of 7 corners have one", "1 normal of no corner: not kept",
                "1 number is rounded to single precision, which holds fewer digits",
                "1 face of more than three corners is cut into triangles around the first corner"}));
  read_mesh(write_test_file("m.obj", kQuad + "vn 0 0 1\nvn 0 1 0\nf 1//1 2//1 3//1\nf 1//2 2//1 3//1\n"), &notes);
  EXPECT_EQ(notes.sentences,
            (std::vector<std::string>{
                "1 vertex is added, because corners of a vertex differ in normal or texture coordinate"}));
  read_mesh(write_test_file("m.obj", kQuad + "# nothing else\nf 1 2 3\n"), &notes);
  EXPECT_TRUE(notes.sentences.empty());
}

TEST(Obj, RefusesAFaceOfSoManyCornersThatItsTimeGrowsWithTheirSquare) {
  const auto fan = [](int corners) {
    std::string content = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf";
    for (int i = 0; i < corners; ++i) content += i % 3 == 0 ? " 1" : i % 3 == 1 ? " 2" : " 3";
    return content + "\n";
  };
  EXPECT_EQ(read_text("m.obj", fan(1000)).triangles.size(), 998u);
  EXPECT_EQ(refused(fan(1001)), "m.obj:4:1: a face of more than 1000 corners; expected at most that many");
  EXPECT_EQ(refused(fan(2000000)), "m.obj:4:1: a face of more than 1000 corners; expected at most that many");
}

}  // namespace
}  // namespace plumb
