#include <algorithm>

#include "meshes/generators/asked_size.h"
#include "meshes/generators/icosphere.h"
#include "meshes/generators/mesh_kind.h"
#include "meshes/generators/progress_steps.h"

namespace plumb {
namespace {

TriangleMesh make(const MeshRequest& request) {
  constexpr std::uint64_t kMostShells = 31;
  const std::uint64_t asked = asked_triangles(request);
  const int subdivisions = icosphere_subdivisions((asked + kMostShells - 1) / kMostShells);
  const TriangleMesh sphere = icosphere(subdivisions, part_of(request.progress, 0, 0.2));
  const std::uint64_t shells =
      std::max<std::uint64_t>(2, (asked + sphere.triangles.size() - 1) / sphere.triangles.size());

  TriangleMesh mesh;
  mesh.positions.reserve(shells * sphere.positions.size());
  mesh.normals.reserve(shells * sphere.positions.size());
  mesh.triangles.reserve(shells * sphere.triangles.size());
  ProgressSteps steps(part_of(request.progress, 0.2, 1), shells);
  for (std::uint64_t shell = shells; shell >= 1; --shell) {
    // Scaled copies of one convex body do not meet, however flat its faces are.
    const double radius = static_cast<double>(shell) / static_cast<double>(shells);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const Point3& p : sphere.positions) mesh.positions.push_back({radius * p.x, radius * p.y, radius * p.z});
    mesh.normals.insert(mesh.normals.end(), sphere.normals.begin(), sphere.normals.end());
    for (const auto& [a, b, c] : sphere.triangles) mesh.triangles.push_back({first + a, first + b, first + c});
    steps.step();
  }
  return mesh;
}

}  // namespace

extern const MeshKind nested_shells_kind{"nested_shells",
                                         "2 to 31 icospheres within one another like the skins of an onion, each "
                                         "closed and each with its front outside.",
                                         true, false, make};

}  // namespace plumb
