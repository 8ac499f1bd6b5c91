#include "meshes/read_mesh.h"

#include <string>
#include <utility>

#include "meshes/formats/file_bytes.h"
#include "meshes/formats/msh_reader.h"
#include "meshes/formats/open_mesh_reader.h"
#include "meshes/formats/stl_reader.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

TriangleMesh read(const std::filesystem::path& file, MeshNotes& notes) {
  const std::string ending = lower_case_ending(file);
  if (ending == ".msh") return read_msh(file, notes);
  if (ending == ".stl") return read_stl(file, notes);
  if (ending == ".obj" || ending == ".ply" || ending == ".off") return read_with_open_mesh(file, notes);
  throw InputError({file.string()},
                   "the ending '" + ending + "' names no mesh format; expected .msh, .obj, .ply, .off or .stl");
}

}  // namespace

TriangleMesh read_mesh(const std::filesystem::path& file, MeshNotes* notes) {
  MeshNotes found;
  TriangleMesh mesh = read(file, found);
  if (found.polygons > 0) {
    found.sentences.push_back(
        counted(found.polygons, "face of more than three corners is cut", "faces of more than three corners are cut") +
        " into triangles around the first corner");
  }
  if (notes != nullptr) *notes = std::move(found);
  return mesh;
}

}  // namespace plumb
