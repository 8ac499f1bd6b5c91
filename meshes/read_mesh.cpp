#include "meshes/read_mesh.h"

#include <string>
#include <string_view>
#include <utility>

#include "meshes/formats/file_bytes.h"
#include "meshes/formats/mapped_file.h"
#include "meshes/formats/msh_reader.h"
#include "meshes/formats/open_mesh_reader.h"
#include "meshes/formats/ply_reader.h"
#include "meshes/formats/stl_reader.h"
#include "meshes/write_mesh.h"

namespace plumb {
namespace {

/// Whether the format is read from a mapped file.
bool is_mapped(const std::string& ending) { return ending == ".msh" || ending == ".ply"; }

TriangleMesh read_mapped(std::string_view content, const std::filesystem::path& file, MeshNotes& notes) {
  if (lower_case_ending(file) == ".ply") return read_ply(content, file, notes);
  return read_msh(content, file.string(), notes);
}

TriangleMesh read_copied(std::string content, const std::filesystem::path& file, MeshNotes& notes) {
  if (lower_case_ending(file) == ".stl") return read_stl(content, file.string(), notes);
  return read_with_open_mesh(std::move(content), file, notes);
}

/// Adds what is to be said whatever the format.
TriangleMesh noted(TriangleMesh mesh, MeshNotes&& found, MeshNotes* notes) {
  if (found.polygons > 0) {
    found.sentences.push_back(
        counted(found.polygons, "face of more than three corners is cut", "faces of more than three corners are cut") +
        " into triangles around the first corner");
  }
  if (notes != nullptr) *notes = std::move(found);
  return mesh;
}

}  // namespace

TriangleMesh read_mesh(const std::filesystem::path& file, MeshNotes* notes) {
  require_mesh_ending(file);  // before a file of gigabytes is read for nothing
  if (!is_mapped(lower_case_ending(file))) return parse_mesh(file_bytes(file), file, notes);
  MeshNotes found;
  const MappedFile mapped(file);
  TriangleMesh mesh = read_mapped(mapped.bytes(), file, found);
  return noted(std::move(mesh), std::move(found), notes);
}

TriangleMesh parse_mesh(std::string content, const std::filesystem::path& file, MeshNotes* notes) {
  require_mesh_ending(file);
  MeshNotes found;
  TriangleMesh mesh = is_mapped(lower_case_ending(file)) ? read_mapped(content, file, found)
                                                         : read_copied(std::move(content), file, found);
  return noted(std::move(mesh), std::move(found), notes);
}

}  // namespace plumb
