#include "meshes/generators/asked_size.h"
#include "meshes/generators/averaged_normals.h"
#include "meshes/generators/mesh_kind.h"
#include "meshes/generators/noise.h"
#include "meshes/generators/progress_steps.h"

namespace plumb {
namespace {

Normal3 up(const Point3&) { return {0, 1, 0}; }

TriangleMesh make(const MeshRequest& request) {
  const std::uint32_t cells = least_size(asked_triangles(request), 1, [](std::uint64_t n) { return 2 * n * n; });
  const std::uint32_t points = cells + 1;
  TriangleMesh mesh;
  mesh.positions.reserve(std::size_t{points} * points);
  mesh.texcoords.reserve(std::size_t{points} * points);
  mesh.triangles.reserve(std::size_t{2} * cells * cells);
  ProgressSteps steps(request.progress, points + 1);
  for (std::uint32_t row = 0; row < points; ++row) {
    for (std::uint32_t column = 0; column < points; ++column) {
      const double u = static_cast<double>(column) / cells, v = static_cast<double>(row) / cells;
      const double x = 2 * u - 1, z = 1 - 2 * v;
      mesh.positions.push_back({x, 0.35 * noise({2 * x, 0.5, 2 * z}, request.seed), z});
      mesh.texcoords.push_back({u, v});
      if (row == cells || column == cells) continue;
      const std::uint32_t a = row * points + column, b = a + 1, c = b + points, d = a + points;
      mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
    }
    steps.step();
  }
  mesh.normals = averaged_normals(mesh, up);
  steps.step();
  return mesh;
}

}  // namespace

extern const MeshKind terrain_kind{"terrain",
                                   "Mountains: a square grid of heights of noise around the plane y = 0, open, with "
                                   "normals and texcoords.",
                                   false, true, make};

}  // namespace plumb
