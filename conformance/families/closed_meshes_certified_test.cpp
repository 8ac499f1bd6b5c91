// Every closed mesh that checks shoot rays at is what they take it for.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "conformance/families/closed_meshes.h"
#include "conformance/families/family.h"
#include "meshes/read_mesh.h"
#include "meshes/validation/mesh_report.h"

namespace plumb {
namespace {

constexpr plumb_precision kPrecisions[] = {PLUMB_FLOAT, PLUMB_DOUBLE};

/// Why a mesh is not fit for these checks; nothing if it is.
std::string unfit(const TriangleMesh& mesh, std::string_view check) {
  for (const MeshFitness& use : mesh_fitness(check_mesh(mesh)))
    if (use.check == check) return use.reason;
  return "no such use";
}

std::string faults(const TriangleMesh& mesh) {
  std::string text;
  for (const MeshFinding& fault : mesh_faults(check_mesh(mesh))) text += fault.sentence + "\n";
  return text;
}

TEST(CertifiedMeshes, NothingEscapesFromClosedOnes) {
  int meshes = 0, refused = 0;
  for (const plumb_precision precision : kPrecisions) {
    for (const ClosedSurface& closed : closed_meshes(precision)) {
      TriangleMesh mesh = *closed.surface.shape.mesh;
      EXPECT_EQ(unfit(mesh, "escape"), "") << closed.name;
      EXPECT_EQ(faults(mesh), "") << closed.name;
      ++meshes;
      // The certificate is worth something: it is refused for a triangle less, or one wound the other way.
      TriangleMesh flipped = mesh;
      std::swap(flipped.triangles.front()[0], flipped.triangles.front()[1]);
      mesh.triangles.pop_back();
      refused += !unfit(mesh, "escape").empty() && !unfit(flipped, "escape").empty();
    }
  }
  EXPECT_EQ(meshes, 28);
  EXPECT_EQ(refused, 28);
}

TEST(CertifiedMeshes, AllHitsThroughThoseOfT12AreEven) {
  int meshes = 0;
  for (const plumb_precision precision : kPrecisions) {
    const auto family = family_kind("T12").make(1, precision);
    for (int i = 0; i < 50; ++i) {
      EXPECT_EQ(unfit(*family->next().surface.shape.mesh, "escape"), "") << i;
      ++meshes;
    }
  }
  EXPECT_EQ(meshes, 100);
}

/// gem.msh has flat facets on purpose.
TEST(CertifiedMeshes, TheSceneLibraryIsSound) {
  int meshes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(PLUMB_SOURCE_DIR "/scenes/library")) {
    if (entry.path().extension() != ".msh") continue;
    const TriangleMesh mesh = read_mesh(entry.path());
    EXPECT_EQ(faults(mesh), "") << entry.path();
    EXPECT_EQ(unfit(mesh, "escape"), "") << entry.path();
    if (!mesh.normals.empty()) {
      EXPECT_EQ(unfit(mesh, "smooth"), "") << entry.path();
    }
    ++meshes;
  }
  EXPECT_GE(meshes, 2);
}

}  // namespace
}  // namespace plumb
