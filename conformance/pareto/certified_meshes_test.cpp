// The meshes that kernels are measured on are what the figures take them for.
#include <gtest/gtest.h>

#include "conformance/pareto/closest_figures.h"
#include "conformance/pareto/speed_figures.h"
#include "meshes/validation/mesh_report.h"

namespace plumb {
namespace {

void expect_certified(const TriangleMesh& mesh, const std::string& name) {
  const MeshReport report = check_mesh(mesh);
  for (const MeshFinding& fault : mesh_faults(report)) ADD_FAILURE() << name << ": " << fault.sentence;
  for (const MeshFitness& use : mesh_fitness(report)) {
    EXPECT_TRUE(use.fit || use.check != "escape") << name << ": " << use.reason;
  }
}

TEST(CertifiedMeshes, OfClosestSurfacesAndSpeed) {
  int meshes = 0;
  for (const plumb_precision precision : {PLUMB_FLOAT, PLUMB_DOUBLE}) {
    for (const ClosestScene& scene : closest_scenes(precision)) {
      expect_certified(*scene.surface.shape.mesh, scene.name);
      ++meshes;
    }
    for (const SubjectSurface& surface : speed_mesh(Rounding(precision)).surfaces) {
      expect_certified(*surface.shape.mesh, "speed");
      ++meshes;
    }
  }
  EXPECT_EQ(meshes, 8);
}

}  // namespace
}  // namespace plumb
