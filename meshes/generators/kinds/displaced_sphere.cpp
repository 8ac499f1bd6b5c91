#include "meshes/generators/asked_size.h"
#include "meshes/generators/averaged_normals.h"
#include "meshes/generators/icosphere.h"
#include "meshes/generators/mesh_kind.h"
#include "meshes/generators/noise.h"
#include "meshes/generators/progress_steps.h"

namespace plumb {
namespace {

Normal3 away_from_the_origin(const Point3& p) { return normalized(as_normal(p - Point3{})); }

/// Each vertex of the icosphere moves along its own ray from the origin: the triangles seen from there stay as they
/// are, next to one another, so none can meet another one, whatever the heights.
TriangleMesh make(const MeshRequest& request) {
  const int subdivisions = icosphere_subdivisions(asked_triangles(request));
  TriangleMesh mesh = icosphere(subdivisions, part_of(request.progress, 0, 0.4));
  ProgressSteps steps(part_of(request.progress, 0.4, 1), mesh.positions.size() + 1);
  for (Point3& p : mesh.positions) {
    // Noise is within -3 and 3, so the radius is positive.
    const double radius = 1 + 0.3 * noise({1.6 * p.x, 1.6 * p.y, 1.6 * p.z}, request.seed);
    p = {radius * p.x, radius * p.y, radius * p.z};
    steps.step();
  }
  mesh.normals = averaged_normals(mesh, away_from_the_origin);
  steps.step();
  return mesh;
}

}  // namespace

extern const MeshKind displaced_sphere_kind{
    "displaced_sphere", "An icosphere with mountains and valleys of noise, a boulder that is star-shaped.", true, true,
    make};

}  // namespace plumb
