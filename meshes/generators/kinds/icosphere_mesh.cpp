#include "meshes/generators/icosphere.h"
#include "meshes/generators/mesh_kind.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

TriangleMesh make(const MeshRequest& request) {
  std::uint64_t triangles = 20;
  int subdivisions = 0;
  for (; triangles < request.triangles && subdivisions < 11; ++subdivisions) triangles *= 4;
  if (subdivisions > 10) throw InputError({}, "an icosphere has at most 20 971 520 triangles, expected no more");
  return icosphere(subdivisions);
}

}  // namespace

extern const MeshKind icosphere_mesh_kind{
    "icosphere", "An icosahedron, its faces cut in four again and again, on the unit sphere.", true, false, make};

}  // namespace plumb
