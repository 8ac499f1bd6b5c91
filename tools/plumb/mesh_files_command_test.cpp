// `plumb mesh info` and `plumb mesh convert`, run as a program.
#include <array>

#include "tools/plumb/program_for_tests.h"

namespace plumb {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// A square of two triangles, with normals, texture coordinates and a number that no float is.
constexpr const char* kSquare =
    "4 2 vertices 0 0 0 1 0 0 1 1 0.1 0 1 0 triangles 0 1 2 0 2 3 "
    "texcoords 0 0 1 0 1 1 0 1 normals 0 0 1 0 0 1 0 0 1 0 0 1\n";

class MeshFilesCommandTest : public ProgramTest {};

TEST_F(MeshFilesCommandTest, InfoTellsWhatAFileHolds) {
  write("square.msh", kSquare);
  EXPECT_EQ(plumb("mesh info square.msh"), 0) << complained_;
  EXPECT_EQ(said_,
            "square.msh: MSH, text, 119 bytes\n"
            "  4 vertices, 2 triangles, normals, texture coordinates\n"
            "  from (0, 0, 0) to (1, 1, 0.1)\n");
  EXPECT_EQ(complained_, "");
}

TEST_F(MeshFilesCommandTest, InfoTellsWhatIsNotRead) {
  write("quad.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nusemtl b\nf 1 2 3 4\n");
  EXPECT_EQ(plumb("mesh info quad.obj"), 0) << complained_;
  EXPECT_THAT(said_, AllOf(HasSubstr("OBJ, text"), HasSubstr("2 triangles, no normals, no texture coordinates"),
                           HasSubstr("  note: statements that are not kept: 1 'mtllib', 1 'usemtl'\n"),
                           HasSubstr("  note: 1 face of more than three corners is cut into triangles")));
}

TEST_F(MeshFilesCommandTest, InfoAsJson) {
  write("square.msh", kSquare);
  write("empty.stl", "solid\nendsolid\n");
  EXPECT_EQ(plumb("mesh info --json square.msh empty.stl"), 0) << complained_;
  const nlohmann::json files = nlohmann::json::parse(said_);
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[0].at("file"), "square.msh");
  EXPECT_EQ(files[0].at("vertices"), 4);
  EXPECT_EQ(files[0].at("triangles"), 2);
  EXPECT_EQ(files[0].at("normals"), true);
  EXPECT_EQ(files[0].at("bounds").at("max"), (nlohmann::json{1.0, 1.0, 0.1}));
  EXPECT_EQ(files[0].at("notes"), nlohmann::json::array());
  EXPECT_EQ(files[1].at("format"), "STL, text");
  EXPECT_TRUE(files[1].at("bounds").is_null());
}

TEST_F(MeshFilesCommandTest, ConvertThroughEveryFormatSaysWhatIsLost) {
  write("square.msh", kSquare);
  for (const char* out : {"s.obj", "s.ply", "s.off --text", "s.stl --text"}) {
    const std::string name = std::string(out).substr(0, 5);
    const bool is_stl = name == "s.stl";
    EXPECT_EQ(plumb(std::string("mesh convert square.msh ") + out), 0) << complained_;
    EXPECT_THAT(said_, HasSubstr(name + ": 4 vertices, 2 triangles\n"));
    EXPECT_THAT(said_, HasSubstr("not carried: 1 of 12 coordinates rounded to single precision, by at most 1.5e-09"));
    EXPECT_EQ(said_.find("normals of 4 vertices") != std::string::npos, is_stl) << said_;
    EXPECT_EQ(plumb("mesh convert " + name + " back.msh"), 0) << complained_;
    EXPECT_THAT(said_, HasSubstr("back.msh: 4 vertices, 2 triangles\n"));
    EXPECT_EQ(said_.find(name + ": 6 corners are joined to 4 vertices") != std::string::npos, is_stl) << said_;
    EXPECT_THAT(content("back.msh"), HasSubstr("0.10000000149011612"));
  }
  EXPECT_THAT(content("s.stl"), HasSubstr("facet normal"));
  EXPECT_EQ(plumb("mesh convert square.msh square.msh"), 0) << complained_;
  EXPECT_EQ(said_, "square.msh: 4 vertices, 2 triangles\n");
  EXPECT_THAT(content("square.msh"), HasSubstr("vertices\n0\n0\n0\n1\n"));
}

TEST_F(MeshFilesCommandTest, MistakesAreStatusTwo) {
  write("square.msh", kSquare);
  write("wrong.msh", "1 0\nvertices\n1 2 x\ntriangles\n");
  write("large.msh", "1 0 vertices 1e39 0 0 triangles\n");
  const std::array<std::array<const char*, 2>, 6> mistakes{
      {{"mesh info none.msh", "none.msh: no such file"},
       {"mesh info wrong.msh", "wrong.msh:3:5: 'x' is not a number"},
       {"mesh info --json square.msh wrong.msh", "wrong.msh:3:5: 'x' is not a number"},
       {"mesh convert square.msh out.gltf", "out.gltf: the ending '.gltf' names no mesh format"},
       {"mesh convert square.msh none/out.ply", "the folder 'none' does not exist"},
       {"mesh convert large.msh out.ply", "1e+39 does not fit the single precision"}}};
  for (const auto& [words, message] : mistakes) {
    EXPECT_EQ(plumb(words), 2) << words;
    EXPECT_THAT(complained_, HasSubstr(message)) << words;
    EXPECT_EQ(said_, "") << words;
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out.ply"));
}

}  // namespace
}  // namespace plumb
