#include "meshes/read_mesh.h"

#include <string>

#include "meshes/formats/file_bytes.h"
#include "meshes/formats/msh_reader.h"
#include "meshes/formats/open_mesh_reader.h"
#include "renderer/math/input_error.h"

namespace plumb {

TriangleMesh read_mesh(const std::filesystem::path& file) {
  const std::string ending = lower_case_ending(file);
  if (ending == ".msh") return read_msh(file);
  if (ending == ".obj" || ending == ".ply" || ending == ".off" || ending == ".stl") return read_with_open_mesh(file);
  throw InputError({file.string()},
                   "the ending '" + ending + "' names no mesh format; expected .msh, .obj, .ply, .off or .stl");
}

}  // namespace plumb
