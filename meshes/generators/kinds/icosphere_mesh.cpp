#include "meshes/generators/asked_size.h"
#include "meshes/generators/icosphere.h"
#include "meshes/generators/mesh_kind.h"

namespace plumb {
namespace {

TriangleMesh make(const MeshRequest& request) {
  return icosphere(icosphere_subdivisions(asked_triangles(request)), request.progress);
}

}  // namespace

extern const MeshKind icosphere_mesh_kind{
    "icosphere", "An icosahedron, its faces cut in four again and again, on the unit sphere.", true, false, make};

}  // namespace plumb
