#include "meshes/editing/manifold.h"

#include <gtest/gtest.h>

#include "meshes/generators/icosphere.h"

namespace plumb {
namespace {

std::string fault(std::vector<std::array<std::uint32_t, 3>> triangles) {
  TriangleMesh mesh;
  mesh.positions.resize(10);
  mesh.triangles = std::move(triangles);
  return manifold_fault(mesh).value_or("");
}

TEST(ManifoldFault, IsNoneForClosedAndOpenSurfaces) {
  EXPECT_EQ(manifold_fault({}), std::nullopt);
  TriangleMesh mesh = icosphere(2);
  EXPECT_EQ(manifold_fault(mesh), std::nullopt);
  mesh.triangles.pop_back();
  EXPECT_EQ(manifold_fault(mesh), std::nullopt);
  EXPECT_EQ(fault({{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {5, 6, 7}}), "");
  EXPECT_EQ(fault({{0, 3, 4}, {0, 2, 3}, {0, 1, 2}}), "");
}

TEST(ManifoldFault, NamesTheFirstWrongPlace) {
  EXPECT_EQ(fault({{0, 1, 2}, {4, 4, 5}}), "triangle 1 has vertex 4 twice");
  EXPECT_EQ(fault({{4, 5, 5}}), "triangle 0 has vertex 5 twice");
  EXPECT_EQ(fault({{5, 4, 5}}), "triangle 0 has vertex 5 twice");
  EXPECT_EQ(fault({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}), "triangles 0 and 2 both run from vertex 0 to vertex 1");
  EXPECT_EQ(fault({{0, 1, 2}, {0, 1, 3}}), "triangles 0 and 1 both run from vertex 0 to vertex 1");
  // Bow ties: of two open fans, of a closed and an open one, of two closed ones.
  EXPECT_EQ(fault({{0, 1, 2}, {0, 3, 4}}), "the triangles at vertex 0 form more than one fan");
  EXPECT_EQ(fault({{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {0, 4, 5}}), "the triangles at vertex 0 form more than one fan");
  EXPECT_EQ(fault({{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {0, 4, 5}, {0, 5, 6}, {0, 6, 4}}),
            "the triangles at vertex 0 form more than one fan");
}

}  // namespace
}  // namespace plumb
