#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <map>

#include "meshes/formats/file_bytes.h"
#include "meshes/formats/write_msh.h"
#include "meshes/mesh_files_for_tests.h"
#include "meshes/read_mesh.h"

namespace plumb {
namespace {

/// The edges with other than one triangle on either side.
std::size_t open_edges(const TriangleMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
  for (const auto& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3];
      balance[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
  }
  return static_cast<std::size_t>(
      std::count_if(balance.begin(), balance.end(), [](const auto& edge) { return edge.second != 0; }));
}

/// Compares with the records behind the header: three floats a vertex, a byte 3 and three ints a face.
void expect_every_number_of(const char* file, const TriangleMesh& mesh) {
  const std::string bytes = file_bytes(file);
  const std::string end = "end_header\n";
  const char* at = bytes.data() + bytes.find(end) + end.size();
  ASSERT_EQ(static_cast<std::size_t>(bytes.data() + bytes.size() - at),
            12 * mesh.positions.size() + 13 * mesh.triangles.size());
  for (const Point3& p : mesh.positions) {
    std::array<float, 3> record;
    std::memcpy(&record, at, sizeof record);
    ASSERT_EQ(p, (Point3{record[0], record[1], record[2]}));
    at += sizeof record;
  }
  for (const auto& triangle : mesh.triangles) {
    std::array<std::uint32_t, 3> record;
    std::memcpy(&record, at + 1, sizeof record);
    ASSERT_EQ(triangle, record);
    at += 1 + sizeof record;
  }
}

TEST(SharedMeshes, BunnyIsReadWhole) {
  const TriangleMesh mesh = read_mesh(PLUMB_SHARED_DIR "/meshes/bunny69k.ply");
  expect_every_number_of(PLUMB_SHARED_DIR "/meshes/bunny69k.ply", mesh);
  EXPECT_EQ(mesh.positions.size(), 35947u);
  EXPECT_EQ(mesh.triangles.size(), 69451u);
  EXPECT_GT(open_edges(mesh), 0u);
}

TEST(SharedMeshes, IgeaIsReadWholeAndClosed) {
  const TriangleMesh mesh = read_mesh(PLUMB_SHARED_DIR "/meshes/igea268k.ply");
  expect_every_number_of(PLUMB_SHARED_DIR "/meshes/igea268k.ply", mesh);
  EXPECT_EQ(mesh.positions.size(), 134345u);
  EXPECT_EQ(mesh.triangles.size(), 268686u);
  EXPECT_EQ(open_edges(mesh), 0u);
}

TEST(SharedMeshes, EveryCourseMeshIsReadAndComesBackFromARoundTrip) {
  int meshes = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(PLUMB_SHARED_DIR "/course")) {
    if (entry.path().extension() != ".msh") continue;
    const TriangleMesh mesh = read_mesh(entry.path());
    EXPECT_FALSE(mesh.triangles.empty()) << entry.path();
    EXPECT_EQ(!mesh.normals.empty(), entry.path().filename().string().find("norms") != std::string::npos ||
                                         entry.path().filename().string().starts_with("sphere"))
        << entry.path();
    write_msh(mesh, test_file("again.msh"));
    EXPECT_EQ(read_mesh(test_file("again.msh")), mesh) << entry.path();
    ++meshes;
  }
  EXPECT_GE(meshes, 11);
}

}  // namespace
}  // namespace plumb
