#include <sstream>

#include "meshes/generators/mesh_kind.h"
#include "meshes/read_mesh.h"
#include "tools/plumb/program_for_tests.h"

namespace plumb {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

using MeshGenerateCommandTest = ProgramTest;

TEST_F(MeshGenerateCommandTest, WritesTheMeshOfTheFamily) {
  for (const MeshKind* kind : mesh_kinds()) {
    const std::string file = std::string(kind->id) + ".msh";
    ASSERT_EQ(plumb("mesh generate " + std::string(kind->id) + " --triangles 700 --seed 3 -o " + file), 0)
        << complained_;
    const TriangleMesh mesh = kind->make({700, 3, {}});
    EXPECT_EQ(read_mesh(folder_ / file), mesh) << kind->id;
    EXPECT_THAT(said_, HasSubstr(file + ": " + std::to_string(mesh.positions.size()) + " vertices, " +
                                 std::to_string(mesh.triangles.size()) + " triangles"));
    EXPECT_EQ(complained_, "") << "a bar where no terminal is";
  }
}

TEST_F(MeshGenerateCommandTest, TheSameBytesWithoutTheCpusVariants) {
  // glibc chooses sin, cos, exp and pow by these features; here as if the processor had none of them.
  const std::string plain = "GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-AVX,-FMA,-FMA4,-AVX512F,-AVX512VL,-SSE4_1,-SSE4_2";
  int compared = 0;
  for (const MeshKind* kind : mesh_kinds()) {
    const std::string generate = "mesh generate " + std::string(kind->id) + " --triangles 3000 -o ";
    ASSERT_EQ(plumb(generate + "usual.msh"), 0) << complained_;
    ASSERT_EQ(plumb(generate + "plain.msh", plain), 0) << complained_;
    EXPECT_TRUE(content("usual.msh") == content("plain.msh")) << kind->id;
    compared += content("usual.msh").size() > 100;
  }
  EXPECT_EQ(compared, 10);
}

TEST_F(MeshGenerateCommandTest, ListsTheFamilies) {
  EXPECT_EQ(plumb("mesh generate --list"), 0) << complained_;
  std::istringstream lines(said_);
  std::string line;
  for (const MeshKind* kind : mesh_kinds()) {
    ASSERT_TRUE(std::getline(lines, line));
    EXPECT_THAT(line, AllOf(testing::StartsWith(std::string(kind->id) + " "),
                            HasSubstr(kind->closed ? "closed" : "open"), HasSubstr(std::string(kind->description))));
  }
  EXPECT_FALSE(std::getline(lines, line));
}

TEST_F(MeshGenerateCommandTest, MistakesAreStatusTwo) {
  EXPECT_EQ(plumb("mesh generate torus_knto -o x.msh"), 2);
  EXPECT_THAT(complained_, AllOf(HasSubstr("'torus_knto'"), HasSubstr("did you mean 'torus_knot'?")));
  EXPECT_EQ(plumb("mesh generate -o x.msh"), 2);
  EXPECT_THAT(complained_, HasSubstr("--list"));
  EXPECT_EQ(plumb("mesh generate city"), 2);
  EXPECT_THAT(complained_, HasSubstr("expected -o FILE"));
  for (const char* number : {"0", "100000001", "-5", "many"}) {
    EXPECT_EQ(plumb("mesh generate city -o x.msh --triangles " + std::string(number)), 2) << number;
    EXPECT_THAT(complained_, Not(testing::IsEmpty()));
  }
  EXPECT_EQ(plumb("mesh generate icosphere -o x.msh --triangles 30000000"), 2);
  EXPECT_THAT(complained_, HasSubstr("at most 20971520"));
  EXPECT_EQ(plumb("mesh generate city -o nowhere/x.msh"), 2);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "x.msh"));
}

}  // namespace
}  // namespace plumb
