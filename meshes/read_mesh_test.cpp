#include "meshes/read_mesh.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "meshes/mesh_files_for_tests.h"

namespace plumb {
namespace {

TEST(ReadMesh, ChoosesTheFormatByTheEndingInAnyCase) {
  EXPECT_EQ(read_text("a.MSH", "1 0 vertices 1 2 3 triangles").positions.size(), 1u);
  EXPECT_EQ(read_text("a.Obj", "v 1 2 3\n").positions.size(), 1u);
  EXPECT_EQ(read_text("a.OFF", "OFF\n1 0 0\n1 2 3\n").positions.size(), 1u);
  EXPECT_EQ(read_text("a.PLY",
                      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float "
                      "z\nend_header\n1 2 3\n")
                .positions.size(),
            1u);
  EXPECT_EQ(read_text("a.Stl", "solid a\nendsolid a\n").positions.size(), 0u);
}

TEST(ReadMesh, RefusesAnotherEnding) {
  EXPECT_EQ(refusal("a.gltf", ""),
            "a.gltf: the ending '.gltf' names no mesh format; expected .msh, .obj, .ply, .off or .stl");
  EXPECT_EQ(refusal("msh", ""), "msh: the ending '' names no mesh format; expected .msh, .obj, .ply, .off or .stl");
}

TEST(ReadMesh, RefusesWhatIsNoReadableFile) {
  for (const char* ending : {".msh", ".obj", ".ply", ".off", ".stl"}) {
    const auto missing = test_file(std::string("missing") + ending);
    const auto folder = test_file(std::string("folder") + ending);
    std::filesystem::create_directories(folder);
    const auto why = [](const std::filesystem::path& file) -> std::string {
      try {
        read_mesh(file);
      } catch (const InputError& error) {
        return error.what();
      }
      return "";
    };
    EXPECT_EQ(why(missing), missing.string() + ": no such file; expected a mesh file");
    EXPECT_EQ(why(folder), folder.string() + ": not a regular file; expected a mesh file");
  }
}

TEST(ReadMesh, RefusesAPipeWithoutWaitingForItsWriter) {
  const auto pipe = test_file("pipe.msh");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  try {
    read_mesh(pipe);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), pipe.string() + ": not a regular file; expected a mesh file");
  }
}

/// A file of /proc says that it has no bytes, and a mapping needs one at least.
TEST(ReadMesh, AFileWithoutBytesIsEmpty) {
  EXPECT_EQ(refusal("empty.msh", ""), "empty.msh:1:1: the file is empty; expected the number of vertices");
  EXPECT_EQ(refusal("empty.ply", ""), "empty.ply:1:1: the line ends; expected ply");
  const auto link = test_file("link.msh");
  std::filesystem::create_symlink("/proc/self/status", link);
  EXPECT_THROW(read_mesh(link), InputError);
}

}  // namespace
}  // namespace plumb
