#include "scenes/load_meshes.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <array>
#include <fstream>

#include "scenes/dialect.h"
#include "scenes/read_scene.h"

namespace plumb {
namespace {

using ::testing::HasSubstr;

constexpr std::array kNetParameters{
    Parameter{.name = "data", .type = ValueType::file, .meaning = ""},
};
constexpr Kind kNet{Role::surface, "Net", "", kNetParameters};

/// A triangle whose first vertex is (0.1, 0, 0), with normals and texture coordinates.
constexpr std::string_view kTriangle =
    "3\n1\nvertices\n.1\n0\n0\n1\n0\n0\n0\n1\n0\ntriangles\n0\n1\n2\nnormals\n0\n0\n.1\n0\n0\n1\n0\n0\n1\n"
    "texcoords\n.1\n0\n1\n0\n0\n1\n";

std::filesystem::path write_file(const std::string& name, std::string_view text) {
  struct Folder {
    ~Folder() { std::filesystem::remove_all(path); }
    std::filesystem::path path =
        std::filesystem::path(::testing::TempDir()) / ("plumb-load-meshes-" + std::to_string(getpid()));
  };
  static const Folder of_this_process;
  const std::filesystem::path& folder = of_this_process.path;
  std::filesystem::create_directories(folder / "below");
  std::ofstream(folder / name, std::ios::binary) << text;
  return folder / name;
}

MeshTable load(const std::string& elements) {
  const auto file = write_file("s.xml", "<scene><image>1 1</image>\n" + elements + "</scene>");
  return load_meshes(read_scene(file, {{&kNet}, {}}));
}

TEST(LoadMeshes, EachFileIsReadOnceWhereverItIsNamed) {
  write_file("a.msh", kTriangle);
  write_file("below/b.msh", kTriangle);
  const MeshTable meshes = load(
      "<surface type='Net'><data>a.msh</data></surface><surface type='Group'><surface type='Group'>"
      "<surface type='Net'><data>\n a.msh </data></surface><surface "
      "type='Net'><data>below/b.msh</data></surface></surface></surface>");
  ASSERT_EQ(meshes.size(), 2u);
  EXPECT_EQ(*meshes.at("a.msh"), *meshes.at("below/b.msh"));
}

TEST(LoadMeshes, AMissingFileIsAnErrorAtItsElement) {
  try {
    load(" <surface type='Net'>\n <data>none.msh</data></surface>");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("s.xml:3:2: the mesh '"));
    EXPECT_THAT(error.what(), HasSubstr("none.msh' does not exist"));
  }
}

TEST(LoadMeshes, ABrokenFileIsAnErrorAtItsOwnLine) {
  write_file("broken.msh", "3\n1\nvertices\n0\n0\n0\n1\nx\n");
  try {
    load("<surface type='Net'><data>broken.msh</data></surface>");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.where().file, ::testing::EndsWith("broken.msh"));
    EXPECT_GT(error.where().line, 0);
  }
}

TEST(LoadMeshes, ASceneWithoutMeshesNeedsNone) { EXPECT_TRUE(load("").empty()); }

TEST(Dialect, NamesAreKnownOrSuggested) {
  for (const std::string_view name : dialect_names()) EXPECT_NO_THROW(dialect_named(name));
  EXPECT_EQ(dialect_named("pa3-2011"), Dialect::pa3_2011);
  try {
    dialect_named("pa3-2012");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("did you mean 'pa3-2011'?"));
  }
}

TEST(LoadMeshes, NumbersAreRoundedToSinglePrecision) {
  write_file("a.msh", kTriangle);
  const MeshTable meshes = load("<surface type='Net'><data>a.msh</data></surface>");
  const TriangleMesh& mesh = *meshes.at("a.msh");
  EXPECT_EQ(mesh.positions[0].x, static_cast<double>(0.1F));
  EXPECT_EQ(mesh.normals[0].z, static_cast<double>(0.1F));
  EXPECT_EQ(mesh.texcoords[0].u, static_cast<double>(0.1F));
  EXPECT_NE(static_cast<double>(0.1F), 0.1);
}

/// Enough of them for the compiler's vectorised loops, which have dropped such roundings.
TEST(LoadMeshes, LongListsAreRoundedToSinglePrecision) {
  constexpr int kVertices = 1001;
  std::string text = std::to_string(kVertices) + " 0 triangles";
  for (const std::string section : {"vertices", "normals", "texcoords"}) {
    text += " " + section;
    for (int i = 0; i < kVertices; ++i) text += section == "texcoords" ? " 2.1 3.1" : " 0.1 1.1 2.1";
  }
  write_file("long.msh", text);
  const MeshTable meshes = load("<surface type='Net'><data>long.msh</data></surface>");
  const TriangleMesh& mesh = *meshes.at("long.msh");
  const double x = 0.1F, y = 1.1F, z = 2.1F, v = 3.1F;
  EXPECT_EQ(mesh.positions, std::vector(kVertices, Point3{x, y, z}));
  EXPECT_EQ(mesh.normals, std::vector(kVertices, Normal3{x, y, z}));
  EXPECT_EQ(mesh.texcoords, std::vector(kVertices, TexCoord{z, v}));
}

}  // namespace
}  // namespace plumb
