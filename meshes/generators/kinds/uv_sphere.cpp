#include "meshes/generators/asked_size.h"
#include "meshes/generators/correctly_rounded.h"
#include "meshes/generators/mesh_kind.h"
#include "meshes/generators/progress_steps.h"

namespace plumb {
namespace {

/// The poles are (0, 1, 0), the first vertex, and (0, -1, 0), the last; between them `stacks` - 1 rings of 2 `stacks`
/// vertices.
TriangleMesh make(const MeshRequest& request) {
  const std::uint32_t stacks = least_size(asked_triangles(request), 2, [](std::uint64_t n) { return 4 * n * (n - 1); });
  const std::uint32_t slices = 2 * stacks;
  // Half a turn in `stacks` steps and a whole one in `slices` are the same steps.
  const std::vector<SinCos> turn = parts_of_a_turn(slices);
  const std::uint32_t rings = stacks - 1, south = 1 + rings * slices;

  TriangleMesh mesh;
  mesh.positions.reserve(south + 1);
  mesh.triangles.reserve(std::size_t{2} * slices * rings);
  ProgressSteps steps(request.progress, 2 * rings);
  mesh.positions.push_back({0, 1, 0});
  for (std::uint32_t ring = 1; ring <= rings; ++ring) {
    for (const SinCos& around : turn)
      mesh.positions.push_back({turn[ring].sin * around.sin, turn[ring].cos, turn[ring].sin * around.cos});
    steps.step();
  }
  mesh.positions.push_back({0, -1, 0});

  const auto vertex = [&](std::uint32_t ring, std::uint32_t slice) { return 1 + ring * slices + slice % slices; };
  for (std::uint32_t ring = 0; ring < rings; ++ring) {
    for (std::uint32_t i = 0; i < slices; ++i) {
      const std::uint32_t a = vertex(ring, i), b = vertex(ring, i + 1);
      if (ring == 0) mesh.triangles.push_back({0, a, b});
      if (ring + 1 == rings) {
        mesh.triangles.push_back({a, south, b});
      } else {
        const std::uint32_t c = vertex(ring + 1, i), d = vertex(ring + 1, i + 1);
        mesh.triangles.insert(mesh.triangles.end(), {{a, c, d}, {a, d, b}});
      }
    }
    steps.step();
  }
  mesh.normals.reserve(mesh.positions.size());
  for (const Point3& p : mesh.positions) mesh.normals.push_back({p.x, p.y, p.z});
  return mesh;
}

}  // namespace

extern const MeshKind uv_sphere_kind{"uv_sphere",
                                     "The unit sphere cut along circles of latitude and longitude, with a fan of thin "
                                     "triangles at each pole; without a seam, so without texcoords.",
                                     true, false, make};

}  // namespace plumb
