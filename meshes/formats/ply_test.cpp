#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "meshes/mesh_files_for_tests.h"

namespace plumb {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;
const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";
const std::string kList = "property list uchar int vertex_indices\n";

std::string refused(const std::string& content) { return refusal("m.ply", content); }

std::string text_header(int vertices, int faces) {
  return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(vertices) + "\n" + kXyz + "element face " +
         std::to_string(faces) + "\n" + kList + "end_header\n";
}
std::string binary_header(int vertices, int faces) {
  return "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(vertices) + "\n" + kXyz +
         "element face " + std::to_string(faces) + "\n" + kList + "end_header\n";
}
std::string triangle(std::int32_t a, std::int32_t b, std::int32_t c) { return "\3" + raw(a) + raw(b) + raw(c); }
std::string point(float x, float y, float z) { return raw(x) + raw(y) + raw(z); }
const std::string kThreePoints = point(0, 0, 0) + point(1, 0, 0) + point(0, .1f, 0);

TEST(Ply, ReadsText) {
  const TriangleMesh mesh = read_text("m.ply", text_header(4, 2) + "0 0 0\n1 0 0\n1 1 0\n0 1 .5\n4 0 1 2 3\n3 0 2 1\n");
  EXPECT_EQ(mesh.positions, (std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, .5}}));
  EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}, {0, 2, 1}}));
}

TEST(Ply, ReadsBinary) {
  const TriangleMesh mesh =
      read_text("m.ply", binary_header(3, 2) + kThreePoints + triangle(0, 1, 2) + triangle(2, 2, 0));
  EXPECT_EQ(mesh.positions, (std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, double(.1f), 0}}));
  EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {2, 2, 0}}));
}

TEST(Ply, ReadsBigEndianDoublesShortsListsAndElementsThatItDoesNotNeed) {
  const auto big = [](auto number) {
    std::string bytes = raw(number);
    std::reverse(bytes.begin(), bytes.end());
    return bytes;
  };
  std::string content =
      "ply\r\nformat binary_big_endian 1.0\r\ncomment by hand\r\nobj_info none\r\nelement camera 2\r\nproperty double "
      "f\r\nproperty list "
      "uchar short k\r\nelement vertex 3\r\nproperty uchar red\r\nproperty double z\r\nproperty double x\r\nproperty "
      "double y\r\nproperty float texture_u\r\nproperty float texture_v\r\nelement face 1\r\nproperty uchar "
      "flags\r\nproperty list ushort ushort vertex_index\r\nproperty list uint float weights\r\nelement nothing "
      "4000000000\r\nend_header\r\n";
  for (int camera = 0; camera < 2; ++camera) content += big(1.5) + "\2" + big(std::int16_t{1}) + big(std::int16_t{-1});
  for (int i = 0; i < 3; ++i) content += "\xff" + big(i + .25) + big(i * 2.) + big(-1.) + big(float(i)) + big(.5f);
  content += "\1" + big(std::uint16_t{3}) + big(std::uint16_t{2}) + big(std::uint16_t{1}) + big(std::uint16_t{0}) +
             big(std::uint32_t{1}) + big(1.f);
  const TriangleMesh mesh = read_text("m.ply", content);
  EXPECT_EQ(mesh.positions, (std::vector<Point3>{{0, -1, .25}, {2, -1, 1.25}, {4, -1, 2.25}}));
  EXPECT_EQ(mesh.texcoords, (std::vector<TexCoord>{{0, .5}, {1, .5}, {2, .5}}));
  EXPECT_EQ(mesh.triangles, (Triangles{{2, 1, 0}}));
}

TEST(Ply, KeepsWholeNormalsOnly) {
  const std::string before =
      "ply\nformat ascii 1.0\nelement vertex 1\n" + kXyz + "property float nx\nproperty float ny\n";
  EXPECT_EQ(read_text("m.ply", before + "property float nz\nend_header\n1 2 3 0 0 2").normals,
            (std::vector<Normal3>{{0, 0, 2}}));
  EXPECT_TRUE(read_text("m.ply", before + "end_header\n1 2 3 0 0").normals.empty());
}

TEST(Ply, KeepsNonManifoldFaces) {
  const TriangleMesh mesh =
      read_text("m.ply", text_header(3, 4) + "0 0 0 1 0 0 0 1 0\n3 0 1 2 3 0 1 2 3 1 0 2 3 0 0 1\n");
  EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {0, 1, 2}, {1, 0, 2}, {0, 0, 1}}));
  EXPECT_EQ(mesh.positions.size(), 3u);
}

TEST(Ply, RefusesCountsThatTheFileIsTooShortFor) {
  const std::string why = " bytes that follow; expected a number that the file holds";
  EXPECT_EQ(refused(text_header(2000000000, 1) + "0 0 0"), "m.ply:3:16: 2000000000 elements do not fit in the 5" + why);
  EXPECT_EQ(refused(text_header(1, 2000000000) + "0 0 0\n"),
            "m.ply:7:14: 2000000000 elements do not fit in the 6" + why);
  EXPECT_EQ(refused(binary_header(2000000000, 0) + kThreePoints),
            "m.ply:3:16: 2000000000 elements do not fit in the 36" + why);
  EXPECT_EQ(refused(binary_header(3, 2000000000) + kThreePoints),
            "m.ply:7:14: 2000000000 elements do not fit in the 36" + why);
}

TEST(Ply, RefusesAWrongHeader) {
  EXPECT_EQ(refused(""), "m.ply:1:1: the line ends; expected ply");
  EXPECT_EQ(refused("plx"), "m.ply:1:1: 'plx' stands here; expected ply");
  EXPECT_EQ(refused("ply\nformat binary 1.0"),
            "m.ply:2:8: 'binary' stands here; expected ascii, binary_little_endian or binary_big_endian");
  EXPECT_EQ(refused("ply\nformat ascii 2.0"), "m.ply:2:14: '2.0' stands here; expected 1.0");
  const std::string start = "ply\nformat ascii 1.0\n";
  EXPECT_EQ(refused(start), "m.ply:3:1: the file ends; expected element, property, comment or end_header");
  EXPECT_EQ(refused(start + "elements vertex 1"),
            "m.ply:3:1: 'elements' stands here; expected element, property, comment or end_header");
  EXPECT_EQ(refused(start + "element vertex -1"),
            "m.ply:3:16: '-1' is not a whole number from 0 to 4294967295; expected the number of elements");
  EXPECT_EQ(refused(start + "element vertex 1 1"), "m.ply:3:18: '1' stands here; expected the end of the line");
  EXPECT_EQ(refused(start + "element"), "m.ply:3:8: the line ends; expected a name");
  EXPECT_EQ(refused(start + "property float x"), "m.ply:3:1: a property of nothing; expected an element first");
  EXPECT_EQ(refused(start + "element vertex 1\nproperty real x"),
            "m.ply:4:10: 'real' stands here; expected a number type such as float, uchar or int");
  EXPECT_EQ(refused(start + "element face 1\nproperty list float int k"),
            "m.ply:4:15: 'float' counts a list; expected a whole number type");
  EXPECT_EQ(refused(start + "end_header\n"),
            "m.ply:4:1: the header has no element vertex before its faces; expected one with x, y and z");
  EXPECT_EQ(refused(start + "element vertex 0\nproperty float x\nproperty float y\nend_header\n"),
            "m.ply:3:9: the vertices have no x, y and z; expected all three");
  EXPECT_EQ(refused(start + "element vertex 0\nproperty list uchar float x\nend_header\n"),
            "m.ply:4:27: a list gives a coordinate; expected a number");
  EXPECT_EQ(refused(start + "element vertex 1\n" + kXyz + "element face 1\nproperty float a\nend_header\n0 0 0 0"),
            "m.ply:7:9: the faces have no list vertex_indices; expected one");
}

TEST(Ply, RefusesFacesWithoutAnyNumbersWhateverTheirCount) {
  const std::string start = "ply\nformat ascii 1.0\nelement vertex 1\n" + kXyz;
  EXPECT_EQ(refused(start + "element face 4000000000\nend_header\n0 0 0\n"),
            "m.ply:7:9: the faces have no list vertex_indices; expected one");
}

TEST(Ply, RefusesAListThatHasNoLength) {
  const std::string start =
      "ply\nformat ascii 1.0\nelement strip 1\nproperty list int int k\nelement vertex 0\n" + kXyz;
  EXPECT_EQ(refused(start + "end_header\n-1\n"),
            "m.ply:10:1: strip 0: the length of a list is wrong; expected a whole number from 0 to 2147483647");
}

TEST(Ply, RefusesAWrongTextBody) {
  EXPECT_EQ(refused(text_header(1, 0) + "0 x 0"), "m.ply:10:3: 'x' is not a number; expected a number");
  EXPECT_EQ(refused(text_header(1, 0) + "0 inf 0"), "m.ply:10:3: 'inf' is not finite; expected a number");
  EXPECT_EQ(refused(text_header(1, 0) + "0 1e39 0"),
            "m.ply:10:3: y of vertex 0 is not finite; expected a finite number of single precision");
  EXPECT_EQ(refused(text_header(1, 0) + "100 200"),
            "m.ply:10:8: the file ends; expected as many numbers as its header says");
  EXPECT_EQ(refused(text_header(1, 0) + "0 0 0\n1"),
            "m.ply:11:1: '1' follows the last element; expected the end of the file");
  EXPECT_EQ(refused(text_header(1, 1) + "0 0 0\n3 0 0 1"),
            "m.ply:11:7: face 0 names vertex 1; expected the index of one of 1 vertices");
  EXPECT_EQ(refused(text_header(1, 1) + "0 0 0\n2 0 0"), "m.ply:11:1: face 0 has 2 corners; expected three or more");
  EXPECT_EQ(refused(text_header(1, 1) + "0 0 0\n3 0 0 -1"),
            "m.ply:11:7: face 0: a vertex index is wrong; expected a whole number from 0 to 2147483647");
  EXPECT_EQ(refused(text_header(1, 1) + "0 0 0\n3.5 0 0 0"),
            "m.ply:11:1: face 0: the number of corners is wrong; expected a whole number from 0 to 2147483647");
  EXPECT_EQ(refused(text_header(1, 1) + "0 0 0\n2000000000 0 0 0"),
            "m.ply:11:17: the file ends; expected as many numbers as its header says");
}

TEST(Ply, RefusesAWrongBinaryBody) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(refused(binary_header(1, 0) + point(0, 0, nan)),
            "m.ply: z of vertex 0 is not finite; expected a finite number of single precision");
  EXPECT_EQ(refused(binary_header(3, 1) + kThreePoints + triangle(0, 1, 3)),
            "m.ply: face 0 names vertex 3; expected the index of one of 3 vertices");
  EXPECT_EQ(refused(binary_header(3, 1) + kThreePoints + triangle(0, 1, -1)),
            "m.ply: face 0: a vertex index is wrong; expected a whole number from 0 to 2147483647");
  EXPECT_EQ(refused(binary_header(3, 1) + kThreePoints + "\2" + raw(0) + raw(1)),
            "m.ply: face 0 has 2 corners; expected three or more");
  EXPECT_EQ(refused(binary_header(3, 1) + kThreePoints + "\3" + raw(0) + raw(1)),
            "m.ply: the file ends; expected as many numbers as its header says");
  EXPECT_EQ(refused(binary_header(3, 1) + kThreePoints + triangle(0, 1, 2) + "!"),
            "m.ply: 1 bytes follow the last element; expected the end of the file");
}

TEST(Ply, NotesWhatIsLeftOut) {
  MeshNotes notes;
  read_mesh(
      write_test_file(
          "m.ply",
          "ply\nformat ascii 1.0\ncomment none\nelement vertex 4\nproperty double x\nproperty float y\nproperty float "
          "z\nproperty uchar red\nproperty float nx\nelement face 1\nproperty list uchar int "
          "vertex_indices\nproperty int material\nelement edge 2\nproperty int a\nend_header\n"
          "0.12345678901 0 0 255 1\n1 0 0 255 1\n1 1 0 255 1\n0 1.1 0 255 1\n4 0 1 2 3 7\n1 2\n"),
      &notes);
  EXPECT_EQ(notes.format, "PLY, text");
  EXPECT_EQ(notes.sentences, (std::vector<std::string>{
                                 "of 4 vertices, these properties are not kept: red, nx",
                                 "of 1 face, these properties are not kept: material",
                                 "the element 'edge', of which there are 2, is not kept",
                                 "1 number is rounded to single precision, which holds fewer digits",
                                 "1 face of more than three corners is cut into triangles around the first corner"}));
  read_mesh(write_test_file("m.ply",
                            "ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty double x\nproperty float "
                            "y\nproperty float z\nend_header\n" +
                                std::string("\x3f\xb9\x99\x99\x99\x99\x99\x9a", 8) + std::string(8, '\0')),
            &notes);
  EXPECT_EQ(notes.format, "PLY, binary, big-endian");
  EXPECT_EQ(notes.sentences,
            (std::vector<std::string>{"1 number is rounded to single precision, which holds fewer digits"}));
}

}  // namespace
}  // namespace plumb
