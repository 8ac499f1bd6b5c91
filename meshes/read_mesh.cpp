#include "meshes/read_mesh.h"

#include <string>
#include <utility>

#include "meshes/formats/file_bytes.h"
#include "meshes/formats/msh_reader.h"
#include "meshes/formats/open_mesh_reader.h"
#include "meshes/formats/stl_reader.h"
#include "meshes/write_mesh.h"

namespace plumb {
namespace {

TriangleMesh read(std::string content, const std::filesystem::path& file, MeshNotes& notes) {
  const std::string ending = lower_case_ending(file);
  if (ending == ".msh") return read_msh(content, file.string(), notes);
  if (ending == ".stl") return read_stl(content, file.string(), notes);
  return read_with_open_mesh(std::move(content), file, notes);
}

}  // namespace

TriangleMesh read_mesh(const std::filesystem::path& file, MeshNotes* notes) {
  require_mesh_ending(file);  // before a file of gigabytes is read for nothing
  return parse_mesh(file_bytes(file), file, notes);
}

TriangleMesh parse_mesh(std::string content, const std::filesystem::path& file, MeshNotes* notes) {
  require_mesh_ending(file);
  MeshNotes found;
  TriangleMesh mesh = read(std::move(content), file, found);
  if (found.polygons > 0) {
    found.sentences.push_back(
        counted(found.polygons, "face of more than three corners is cut", "faces of more than three corners are cut") +
        " into triangles around the first corner");
  }
  if (notes != nullptr) *notes = std::move(found);
  return mesh;
}

}  // namespace plumb
