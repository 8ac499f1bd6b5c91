#include "meshes/formats/write_msh.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "meshes/formats/file_bytes.h"
#include "meshes/generators/icosphere.h"
#include "meshes/mesh_files_for_tests.h"

namespace plumb {
namespace {

/// Whether two numbers are the same bits: == takes -0 for 0.
bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

TEST(WriteMsh, WritesOneWordOrNumberALine) {
  const auto file = test_file("one.msh");
  write_msh({{{0, -0.5, 1e300}}, {{0, 0, 0}}, {{0, 0, 1}}, {{0.1, 2}}}, file);
  EXPECT_EQ(file_bytes(file),
            "1\n1\nvertices\n0\n-0.5\n1e+300\ntriangles\n0\n0\n0\ntexcoords\n0.1\n2\nnormals\n0\n0\n1\n");
}

TEST(WriteMsh, ARoundTripKeepsEveryBit) {
  std::mt19937_64 random(20240501);
  TriangleMesh mesh;
  const double least = std::numeric_limits<double>::denorm_min(), most = std::numeric_limits<double>::max();
  mesh.positions = {{0.0, -0.0, least}, {-least, most, -most}, {std::numeric_limits<double>::min(), 0.1, 1.0 / 3}};
  while (mesh.positions.size() < 5000) {
    const auto any = [&] { return std::bit_cast<double>(random()); };
    if (const Point3 p{any(), any(), any()}; is_finite(p)) mesh.positions.push_back(p);
  }
  for (std::uint32_t i = 0; i < 5000; ++i) {
    mesh.triangles.push_back({i, (i * 7 + 1) % 5000, (i * i) % 5000});
    const Point3& p = mesh.positions[4999 - i];
    mesh.normals.push_back({p.x, p.y, p.z});
    mesh.texcoords.push_back({p.z, p.x});
  }
  const auto file = test_file("bits.msh");
  write_msh(mesh, file);
  const TriangleMesh read = read_mesh(file);
  EXPECT_EQ(read, mesh);
  int numbers = 0;
  for (std::size_t i = 0; i < 5000; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_TRUE(same_bits(read.positions[i][axis], mesh.positions[i][axis]))
          << std::hexfloat << mesh.positions[i][axis];
      ASSERT_TRUE(same_bits(read.normals[i][axis], mesh.normals[i][axis])) << std::hexfloat << mesh.normals[i][axis];
      numbers += 2;
    }
    ASSERT_TRUE(same_bits(read.texcoords[i].u, mesh.texcoords[i].u) &&
                same_bits(read.texcoords[i].v, mesh.texcoords[i].v));
    numbers += 2;
  }
  EXPECT_EQ(numbers, 40000);
}

TEST(WriteMsh, ReplacesAFileAndLeavesNoOther) {
  const auto folder = test_file("alone");
  std::filesystem::create_directories(folder);
  write_msh(icosphere(1), folder / "m.msh");
  write_msh({}, folder / "m.msh");
  EXPECT_EQ(file_bytes(folder / "m.msh"), "0\n0\nvertices\ntriangles\n");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1);
}

TEST(WriteMsh, ThrowsInputErrorWhereNoFileCanBe) {
  EXPECT_THROW(write_msh({}, test_file("no such folder") / "m.msh"), InputError);
  const auto folder = test_file("a folder.msh");
  std::filesystem::create_directories(folder / "with something in it");
  EXPECT_THROW(write_msh({}, folder), InputError);
  for (const auto& entry : std::filesystem::directory_iterator(folder.parent_path())) {
    EXPECT_NE(entry.path().extension(), ".tmp") << entry.path();
  }
}

TEST(WriteMsh, RefusesAMeshThatCannotBeReadBack) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto file = test_file("never.msh");
  EXPECT_THROW(write_msh({{{0, nan, 0}}, {}, {}, {}}, file), std::invalid_argument);
  EXPECT_THROW(write_msh({{{0, 0, 0}}, {{0, 0, 1}}, {}, {}}, file), std::invalid_argument);
  EXPECT_THROW(write_msh({{{0, 0, 0}}, {}, {{0, 0, 1}, {0, 0, 1}}, {}}, file), std::invalid_argument);
  EXPECT_THROW(write_msh({{{0, 0, 0}}, {}, {{0, 0, -1 / 0.0}}, {}}, file), std::invalid_argument);
  EXPECT_THROW(write_msh({{{0, 0, 0}}, {}, {}, {{0, nan}}}, file), std::invalid_argument);
  EXPECT_THROW(write_msh({{}, {}, {}, {{0, 0}}}, file), std::invalid_argument);
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(WriteMsh, TheSceneLibrarysIcosphereIsWhatTheGeneratorGives) {
  const auto file = test_file("icosphere320.msh");
  write_msh(icosphere(2), file);
  EXPECT_TRUE(file_bytes(file) == file_bytes(PLUMB_SOURCE_DIR "/scenes/library/icosphere320.msh"))
      << "run make_library_meshes " PLUMB_SOURCE_DIR "/scenes/library if the generator was meant to change";
}

}  // namespace
}  // namespace plumb
