#include "meshes/write_mesh.h"

#include "meshes/formats/write_msh.h"

namespace plumb {

MeshLosses write_mesh(const TriangleMesh& mesh, const std::filesystem::path& file, const MeshWriting&) {
  write_msh(mesh, file);
  return {};
}

}  // namespace plumb
