#include "meshes/read_mesh.h"

#include <string>
#include <utility>

#include "meshes/formats/file_bytes.h"
#include "meshes/formats/msh_reader.h"
#include "meshes/formats/open_mesh_reader.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

/// Throws InputError if it names no format.
bool is_msh(const std::filesystem::path& file) {
  const std::string ending = lower_case_ending(file);
  if (ending == ".msh") return true;
  if (ending == ".obj" || ending == ".ply" || ending == ".off" || ending == ".stl") return false;
  throw InputError({file.string()},
                   "the ending '" + ending + "' names no mesh format; expected .msh, .obj, .ply, .off or .stl");
}

}  // namespace

TriangleMesh read_mesh(const std::filesystem::path& file) {
  return is_msh(file) ? read_msh(file) : read_with_open_mesh(file);
}

TriangleMesh parse_mesh(std::string content, const std::filesystem::path& file) {
  return is_msh(file) ? parse_msh(content, file.string()) : parse_with_open_mesh(std::move(content), file);
}

}  // namespace plumb
