#include <gtest/gtest.h>

#include <limits>

#include "meshes/mesh_files_for_tests.h"

namespace plumb {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

std::string refused(const std::string& content) { return refusal("m.off", content); }

TEST(Off, ReadsTextWithCommentsColoursAndPolygons) {
  const std::string vertices = "0 0 0\n1 0 0 # right\n\n1 1 0\n0 1 .5\n";
  const TriangleMesh mesh =
      read_text("m.off", "OFF # by hand\r\n# counts\r\n4 3 0\r\n" + vertices + "4 0 1 2 3 255 0 0\n3 0 2 1 1\n3 0 0 1");
  EXPECT_EQ(mesh.positions, (std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, .5}}));
  EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}, {0, 2, 1}, {0, 0, 1}}));
  EXPECT_EQ(read_text("m.off", "OFF 4 0 0\n" + vertices).positions, mesh.positions);
}

TEST(Off, ReadsNormalsAndTexcoords) {
  EXPECT_EQ(read_text("m.off", "NOFF\n1 0 0\n1 2 3 0 0 1\n").normals, (std::vector<Normal3>{{0, 0, 1}}));
  const TriangleMesh mesh = read_text(
      "m.off", "STCNOFF\n2 1 0\n1 2 3 0 0 1 255 255 255 .5 .25\n1 2 4 0 0 2 .1 .2 .3 1 0 .75\n3 0 1 0 0 0 0\n");
  EXPECT_EQ(mesh.positions, (std::vector<Point3>{{1, 2, 3}, {1, 2, 4}}));
  EXPECT_EQ(mesh.normals, (std::vector<Normal3>{{0, 0, 1}, {0, 0, 2}}));
  EXPECT_EQ(mesh.texcoords, (std::vector<TexCoord>{{.5, .25}, {0, .75}}));
  EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 0}}));
  // The kind of the file before must not stay behind in the reader.
  EXPECT_TRUE(read_text("n.off", "COFF\n1 0 0\n1 2 3 255 0 0 255\n").normals.empty());
}

TEST(Off, ReadsBinary) {
  std::string content = "NOFF BINARY\n" + raw(3u) + raw(2u) + raw(0u);
  for (const float x : {0.f, 1.f, 2.f}) content += raw(x) + raw(.1f) + raw(0.f) + raw(0.f) + raw(0.f) + raw(1.f);
  content += raw(3u) + raw(0u) + raw(1u) + raw(2u) + raw(4u) + raw(2u) + raw(1u) + raw(0u) + raw(0u);
  const TriangleMesh mesh = read_text("m.off", content);
  EXPECT_EQ(mesh.positions, (std::vector<Point3>{{0, double(.1f), 0}, {1, double(.1f), 0}, {2, double(.1f), 0}}));
  EXPECT_EQ(mesh.normals, std::vector<Normal3>(3, {0, 0, 1}));
  EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {2, 1, 0}, {2, 0, 0}}));
}

TEST(Off, RefusesAWrongText) {
  const std::string kinds =
      " opens the file; expected OFF, NOFF, COFF, STOFF or their combinations in three dimensions";
  EXPECT_EQ(refused(""), "m.off:1:1: ''" + kinds);
  EXPECT_EQ(refused("4OFF\n0 0 0"), "m.off:1:1: '4OFF'" + kinds);
  EXPECT_EQ(refused("OFF\n1 x 0"),
            "m.off:2:3: 'x' is not a whole number from 0 to 4294967295; expected the number of faces");
  EXPECT_EQ(refused("OFF\n1 1"), "m.off:2:4: nothing stands here; expected the number of edges");
  EXPECT_EQ(refused("OFF\n1 1 0 9"), "m.off:2:7: '9' stands here; expected the end of the line");
  const std::string why = " bytes that follow; expected a number that the file holds";
  EXPECT_EQ(refused("OFF\n2000000000 1 0\n0 0 0"), "m.off:2:1: 2000000000 vertices do not fit in the 6" + why);
  EXPECT_EQ(refused("OFF\n1 2000000000 0\n0 0 0"), "m.off:2:3: 2000000000 faces do not fit in the 6" + why);
  EXPECT_EQ(refused("OFF\n1 0 0\n0 0 x\n"), "m.off:3:5: 'x' is not a number; expected the numbers of a vertex");
  EXPECT_EQ(refused("OFF\n1 0 0\n0 0 nan\n"), "m.off:3:5: 'nan' is not finite; expected the numbers of a vertex");
  EXPECT_EQ(refused("OFF\n1 0 0\n0 -1e39 0\n"),
            "m.off:3:3: '-1e39' does not fit single precision; expected the numbers of a vertex");
  EXPECT_EQ(refused("OFF\n1 0 0\n0 0\n0\n"), "m.off:3:4: nothing stands here; expected 3 numbers of a vertex");
  EXPECT_EQ(refused("OFF\n2 0 0\n100 200 300\n"), "m.off:4:1: the file ends in the vertices: 1 of 2 read");
  EXPECT_EQ(refused("OFF\n1 2 0\n0 0 0\n3 0 0 0 0.5 0.5 0.5"), "m.off:4:20: the file ends in the faces: 1 of 2 read");
  EXPECT_EQ(refused("OFF\n1 1 0\n0 0 0\n3 0 0 1"),
            "m.off:4:7: '1' is out of range; expected the index of one of 1 vertices");
  EXPECT_EQ(refused("OFF\n1 1 0\n0 0 0\n2 0 0   "), "m.off:4:1: a face of 2 corners; expected three or more");
  EXPECT_EQ(refused("OFF\n1 1 0\n0 0 0\n9 0 0 0"), "m.off:4:8: nothing stands here; expected a vertex index");
  EXPECT_EQ(refused("OFF\n1 1 0\n0 0 0\n3 0 0 0 red"),
            "m.off:4:9: 'red' is not a number; expected a colour or the end of the line");
  EXPECT_EQ(refused("OFF\n1 0 0\n0 0 0\n3 0 0 0"),
            "m.off:4:1: '3' follows the last face; expected the end of the file");
  EXPECT_EQ(refused(" OFF\n1 0 0\n0 0 0\n"), "m.off: OpenMesh reads 0 of 0 faces; expected a file that it reads whole");
}

TEST(Off, RefusesAWrongBinary) {
  const std::string point = raw(0.f) + raw(0.f) + raw(0.f);
  EXPECT_EQ(refused("COFF BINARY\n"),
            "m.off:1:6: binary OFF with colours has no agreed layout; expected OFF, NOFF, STOFF or STNOFF");
  EXPECT_EQ(refused("OFF BINARY\n" + raw(2000000000u) + raw(2000000000u) + raw(0u)),
            "m.off: 2000000000 vertices and 2000000000 faces do not fit in the 0 bytes that follow; expected "
            "little-endian numbers that the file holds");
  EXPECT_EQ(refused("OFF BINARY\n" + raw(1u)),
            "m.off: the file ends within its numbers; expected as many as its counts say");
  EXPECT_EQ(refused("OFF BINARY\n" + raw(1u) + raw(0u) + raw(0u) + raw(std::numeric_limits<float>::infinity()) +
                    raw(0.f) + raw(0.f)),
            "m.off: a number of vertex 0 is not finite; expected finite numbers");
  const std::string start = "OFF BINARY\n" + raw(1u) + raw(1u) + raw(0u) + point;
  EXPECT_EQ(refused(start + raw(2u) + raw(0u) + raw(0u) + raw(0u)),
            "m.off: face 0 has 2 corners; expected three or more");
  EXPECT_EQ(refused(start + raw(3u) + raw(0u) + raw(0u) + raw(1u)),
            "m.off: face 0 names vertex 1; expected the index of one of 1 vertices");
  EXPECT_EQ(refused(start + raw(2000000000u) + raw(0u) + raw(0u) + raw(0u)),
            "m.off: the file ends within its numbers; expected as many as its counts say");
  EXPECT_EQ(refused(start + raw(3u) + raw(0u) + raw(0u) + raw(0u) + "!"),
            "m.off: 1 bytes follow the last face; expected the end of the file");
}

TEST(Off, NotesWhatIsLeftOut) {
  MeshNotes notes;
  read_mesh(write_test_file("m.off",
                            "COFF\n4 2 0\n0 0 0 255 0 0\n1 0 0 255 0 0\n1 1 0.12345678901 255 0 0\n0 1 0 255 0 0\n4 0 "
                            "1 2 3\n3 0 1 2 9 9 9\n"),
            &notes);
  EXPECT_EQ(notes.format, "OFF, text");
  EXPECT_EQ(notes.sentences,
            (std::vector<std::string>{
                "colours, or other further numbers, of 4 vertices are not kept", "colours of 1 face are not kept",
                "1 number is rounded to single precision, which holds fewer digits",
                "1 face of more than three corners is cut into triangles around the first corner"}));
}

}  // namespace
}  // namespace plumb
