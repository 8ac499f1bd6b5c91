#include "meshes/write_mesh.h"

#include "meshes/formats/file_bytes.h"
#include "meshes/formats/mesh_losses.h"
#include "meshes/formats/open_mesh_writer.h"
#include "meshes/formats/sound_mesh.h"
#include "meshes/formats/staged_mesh_file.h"
#include "meshes/formats/write_msh.h"
#include "meshes/formats/write_stl.h"
#include "renderer/math/input_error.h"

namespace plumb {

void require_mesh_ending(const std::filesystem::path& file) {
  const std::string ending = lower_case_ending(file);
  if (ending == ".msh" || ending == ".obj" || ending == ".ply" || ending == ".off" || ending == ".stl") return;
  throw InputError({file.string()},
                   "the ending '" + ending + "' names no mesh format; expected .msh, .obj, .ply, .off or .stl");
}

MeshLosses write_mesh(const TriangleMesh& mesh, const std::filesystem::path& file, const MeshWriting& options) {
  require_mesh_ending(file);
  const std::string ending = lower_case_ending(file);
  if (ending == ".msh") {
    write_msh(mesh, file, options.progress);
    return {};
  }
  require_sound(mesh);
  MeshLosses losses = losses_of(mesh, ending, file);
  StagedMeshFile staged(file);
  if (ending == ".stl") {
    write_stl(mesh, options.text, staged.stream(), options.progress);
  } else if (!write_with_open_mesh(mesh, ending, options.text, staged.stream(), options.progress) && staged.stream()) {
    throw InputError({file.string()}, "OpenMesh cannot write the mesh; expected one that its format can hold");
  }
  staged.commit();
  return losses;
}

}  // namespace plumb
