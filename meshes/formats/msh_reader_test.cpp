#include "meshes/formats/msh_reader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "meshes/mesh_files_for_tests.h"

namespace plumb {
namespace {

std::string refused(const std::string& content) { return refusal("m.msh", content); }

TEST(MshReader, ReadsEverySectionInAnyOrderAndAnyWhiteSpace) {
  const TriangleMesh mesh = read_text("m.msh",
                                      "3\r\n1\r\ntriangles\r\n0 +1\t2\r\nnormals 0 0 1  0 0 2  0 0 3\r\n"
                                      "vertices\r\n0 0 0\r\n+1.5 0 0\r\n0 -2e-3 .5\r\ntexcoords 0 0 1 0 0 1");
  EXPECT_EQ(mesh.positions, (std::vector<Point3>{{0, 0, 0}, {1.5, 0, 0}, {0, -2e-3, .5}}));
  EXPECT_EQ(mesh.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}}));
  EXPECT_EQ(mesh.normals, (std::vector<Normal3>{{0, 0, 1}, {0, 0, 2}, {0, 0, 3}}));
  EXPECT_EQ(mesh.texcoords, (std::vector<TexCoord>{{0, 0}, {1, 0}, {0, 1}}));
}

TEST(MshReader, KeepsDegenerateAndRepeatedTriangles) {
  const TriangleMesh mesh = read_text("m.msh", "2 3 vertices 0 0 0 1 1 1 triangles 0 0 0 0 1 1 0 1 1");
  EXPECT_EQ(mesh.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 0, 0}, {0, 1, 1}, {0, 1, 1}}));
}

TEST(MshReader, AMeshMayBeEmpty) {
  EXPECT_EQ(read_text("m.msh", "0 0 vertices triangles"), TriangleMesh{});
  EXPECT_EQ(read_text("m.msh", "0\n0\nvertices\ntriangles\nnormals\ntexcoords\n"), TriangleMesh{});
  EXPECT_EQ(read_text("m.msh", "1 0 triangles vertices 1 2 3").positions, (std::vector<Point3>{{1, 2, 3}}));
}

/// Long and short numbers, with and without exponents, as far into the file as to its last bytes.
TEST(MshReader, ReadsEveryKindOfNumberAtEveryDistanceFromTheEnd) {
  const std::vector<std::pair<std::string, double>> numbers = {{"0.1", 0.1},
                                                               {"-0", -0.0},
                                                               {"+7", 7},
                                                               {".5", .5},
                                                               {"5.", 5},
                                                               {"1e-7", 1e-7},
                                                               {"-2.5E3", -2.5e3},
                                                               {"0.10000000149011612", 0.10000000149011612},
                                                               {"123456789.123456789", 123456789.123456789},
                                                               {"0.3333333333333333333333333", 1. / 3},
                                                               {"9007199254740993", 9007199254740992.},
                                                               {"4.9e-324", 4.9e-324}};
  int cases = 0;
  for (std::size_t padding = 0; padding < 60; ++padding) {
    std::string text = "12\r\n0\r\ntriangles vertices";
    for (std::size_t i = 0; i < 36; ++i) text += (i % 3 == 0 ? "\r\n" : " ") + numbers[i % numbers.size()].first;
    const TriangleMesh mesh = read_text("m.msh", text + std::string(padding, '\n'));
    for (std::size_t i = 0; i < 36; ++i, ++cases) {
      const double read = mesh.positions[i / 3][static_cast<int>(i % 3)], expected = numbers[i % numbers.size()].second;
      ASSERT_EQ(read, expected) << i;
      ASSERT_EQ(std::signbit(read), std::signbit(expected)) << i;
    }
  }
  EXPECT_EQ(cases, 60 * 36);
}

/// Behind numbers that are read in the fast way, a wrong one is still found at its place.
TEST(MshReader, NamesThePlaceOfAWrongNumberFarFromTheEnd) {
  const std::string behind = std::string(100, '\n') + "triangles\n0 1 0\n" + std::string(100, '\n');
  const std::string start = "2 1\nvertices\n0.5 0.25\n";
  EXPECT_EQ(refused(start + "1.5f 0 0 0" + behind),
            "m.msh:4:1: '1.5f' is not a number; expected number 3 of 6 of the vertices");
  EXPECT_EQ(refused(start + "0 0 0 1e400" + behind),
            "m.msh:4:7: '1e400' does not fit double precision; expected number 6 of 6 of the vertices");
  EXPECT_EQ(refused("2 1\ntriangles\n0\n1\n2\nvertices" + behind),
            "m.msh:5:1: '2' is out of range; expected a vertex index from 0 to 1 (number 3 of 3 of the triangles)");
  EXPECT_EQ(refused("2 1\ntriangles\n0\n1 4294967296\nvertices" + behind),
            "m.msh:4:3: '4294967296' is not a vertex index; expected a vertex index from 0 to 1 (number 3 of 3 of the "
            "triangles)");
}

TEST(MshReader, RefusesAnEmptyFile) {
  EXPECT_EQ(refused(""), "m.msh:1:1: the file is empty; expected the number of vertices");
  EXPECT_EQ(refused("\n \n"), "m.msh:3:1: the file is empty; expected the number of vertices");
  EXPECT_EQ(refused("0\n"), "m.msh:2:1: the file ends; expected the number of triangles");
}

TEST(MshReader, RefusesACountThatIsNone) {
  const std::string why = " is not a whole number from 0 to 4294967295; expected the number of ";
  EXPECT_EQ(refused("-3 1"), "m.msh:1:1: '-3'" + why + "vertices");
  EXPECT_EQ(refused("0\nx"), "m.msh:2:1: 'x'" + why + "triangles");
  EXPECT_EQ(refused("3.0 1"), "m.msh:1:1: '3.0'" + why + "vertices");
  EXPECT_EQ(refused("99999999999999999999 1"), "m.msh:1:1: '99999999999999999999'" + why + "vertices");
}

TEST(MshReader, RefusesACountThatTheFileIsTooShortFor) {
  EXPECT_EQ(refused("2000000000\n1\nvertices\n0\n"),
            "m.msh:1:1: 2000000000 vertices do not fit in the 14 bytes that follow; expected a number of vertices that "
            "the file holds");
  EXPECT_EQ(refused("1\n4294967295\nvertices\n0\n"),
            "m.msh:2:1: 4294967295 triangles do not fit in the 12 bytes that follow; expected a number of triangles "
            "that the file holds");
}

TEST(MshReader, RefusesWhatIsNoFiniteNumber) {
  const std::string start = "1 0\nvertices\n", end = "\n0\n0\ntriangles\n";
  const std::string where = "; expected number 1 of 3 of the vertices";
  EXPECT_EQ(refused(start + "abc" + end), "m.msh:3:1: 'abc' is not a number" + where);
  EXPECT_EQ(refused(start + "1,5" + end), "m.msh:3:1: '1,5' is not a number" + where);
  EXPECT_EQ(refused(start + "+-1" + end), "m.msh:3:1: '+-1' is not a number" + where);
  EXPECT_EQ(refused(start + "0x10" + end), "m.msh:3:1: '0x10' is not a number" + where);
  EXPECT_EQ(refused(start + "nan" + end), "m.msh:3:1: 'nan' is not finite" + where);
  EXPECT_EQ(refused(start + "-inf" + end), "m.msh:3:1: '-inf' is not finite" + where);
  EXPECT_EQ(refused(start + "1e999" + end), "m.msh:3:1: '1e999' does not fit double precision" + where);
  EXPECT_EQ(refused("1 0\nvertices\n0  triangles\n0\n0\n"),
            "m.msh:3:4: 'triangles' is not a number; expected number 2 of 3 of the vertices");
  EXPECT_EQ(refused("1 0\nvertices 0 0 0\ntriangles\nnormals 0 0 inf"),
            "m.msh:4:13: 'inf' is not finite; expected number 3 of 3 of the normals");
  EXPECT_EQ(refused("1 0\nvertices 0 0 0\ntriangles\ntexcoords\n0\nu"),
            "m.msh:6:1: 'u' is not a number; expected number 2 of 2 of the texcoords");
}

TEST(MshReader, RefusesAMissingKeyword) {
  EXPECT_EQ(refused("0 0 vertices\n"),
            "m.msh:2:1: the file ends without the keyword 'triangles'; expected it and its numbers");
  EXPECT_EQ(refused("0 0 triangles"),
            "m.msh:1:14: the file ends without the keyword 'vertices'; expected it and its numbers");
  EXPECT_EQ(refused("1\n0\n0.5\n0\n0\ntriangles\n"),
            "m.msh:3:1: the number '0.5' follows the counts; expected a keyword or the end of the file");
}

TEST(MshReader, RefusesAMisspeltKeywordAndNamesTheNearest) {
  EXPECT_EQ(refused("0 0\nvertcies\ntriangles"), "m.msh:2:1: 'vertcies' is not a keyword; expected 'vertices'");
  EXPECT_EQ(refused("0 0\nvertices\nTriangles"), "m.msh:3:1: 'Triangles' is not a keyword; expected 'triangles'");
  EXPECT_EQ(refused("0 0 vertices triangles normal"), "m.msh:1:24: 'normal' is not a keyword; expected 'normals'");
  EXPECT_EQ(refused("0 0 vertices triangles texcoord"),
            "m.msh:1:24: 'texcoord' is not a keyword; expected 'texcoords'");
  EXPECT_EQ(refused("0 0\nfaces"),
            "m.msh:2:1: 'faces' is not a keyword; expected vertices, triangles, texcoords or normals, or the end of "
            "the file");
}

TEST(MshReader, RefusesAKeywordGivenTwice) {
  EXPECT_EQ(refused("0 0\nvertices\ntriangles\nvertices\n"),
            "m.msh:4:1: a second 'vertices'; expected each keyword at most once");
}

TEST(MshReader, RefusesATruncatedFile) {
  EXPECT_EQ(refused("2 0\nvertices\n100 200 300\n400"),
            "m.msh:4:4: the file ends in the vertices: 4 of 6 numbers read");
  EXPECT_EQ(refused("1 1\nvertices 0.125 0.25 0.5\ntriangles\n0\n0\n"),
            "m.msh:6:1: the file ends in the triangles: 2 of 3 numbers read");
  EXPECT_EQ(refused("1 0\nvertices 0 0 0\ntriangles\nnormals\n0"),
            "m.msh:5:2: the file ends in the normals: 1 of 3 numbers read");
  EXPECT_EQ(refused("1 0\nvertices 0 0 0\ntriangles\ntexcoords\n"),
            "m.msh:5:1: the file ends in the texcoords: 0 of 2 numbers read");
}

TEST(MshReader, RefusesAnIndexOutOfRange) {
  const std::string start = "2 1\nvertices 0 0 0 1 1 1\ntriangles\n0\n1\n";
  const std::string expected = "; expected a vertex index from 0 to 1 (number 3 of 3 of the triangles)";
  EXPECT_EQ(refused(start + "2\n"), "m.msh:6:1: '2' is out of range" + expected);
  EXPECT_EQ(refused(start + "-1\n"), "m.msh:6:1: '-1' is not a vertex index" + expected);
  EXPECT_EQ(refused(start + "1.0\n"), "m.msh:6:1: '1.0' is not a vertex index" + expected);
  EXPECT_EQ(
      refused("0 1 vertices triangles 0 0 0"),
      "m.msh:1:24: '0' is out of range; expected no index, the mesh has no vertices (number 1 of 3 of the triangles)");
}

TEST(MshReader, RefusesTrailingGarbage) {
  EXPECT_EQ(
      refused("1 0\nvertices\n0\n0\n0\n7\ntriangles\n"),
      "m.msh:6:1: the number '7' follows the last number of the vertices; expected a keyword or the end of the file");
  EXPECT_EQ(
      refused("0 0 vertices triangles\n}"),
      "m.msh:2:1: '}' is not a keyword; expected vertices, triangles, texcoords or normals, or the end of the file");
}

}  // namespace
}  // namespace plumb
