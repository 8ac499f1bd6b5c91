#include "meshes/formats/ply_reader.h"

#include <limits>
#include <string>
#include <utility>

#include "meshes/formats/open_mesh_reader.h"
#include "meshes/formats/ply_columns.h"
#include "meshes/formats/ply_records.h"
#include "meshes/formats/prepare.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

/// Reads the body of a binary file. What takes long in large files, vertices without lists and faces that are nothing
/// but triangles, is copied by ply_columns; the rest, and everything that is wrong, is taken number by number.
class BinaryPlyReader {
 public:
  BinaryPlyReader(const PlyHeader& header, const PlyLayout& layout, std::string_view content, PlyNumbers numbers)
      : header_(header), layout_(layout), content_(content), records_(layout, std::move(numbers)) {}

  TriangleMesh read(MeshNotes& notes) {
    for (const PlyElement& element : header_.elements) {
      // Without properties there is nothing to walk through, whatever the count says.
      if (element.properties.empty()) continue;
      if (&element == layout_.vertex) {
        read_vertices(element);
      } else if (&element == layout_.face) {
        read_faces(element);
      } else {
        for (std::uint32_t i = 0; i < element.count; ++i) records_.skip(element, i);
      }
    }
    records_.numbers().expect_end();
    notes = ply_notes(header_, layout_, polygons_, rounded_ + records_.rounded());
    return std::move(mesh_);
  }

 private:
  void read_vertices(const PlyElement& element) {
    mesh_.positions.resize(element.count);
    if (layout_.sources[kPlyNormal]) mesh_.normals.resize(element.count);
    if (layout_.sources[kPlyTexcoord]) mesh_.texcoords.resize(element.count);
    if (const auto rounded = copy_ply_vertices(header_, layout_, rest(), mesh_)) {
      rounded_ = *rounded;
      records_.numbers().pass(element.count * *fixed_size_of(element));
      return;
    }
    for (std::uint32_t i = 0; i < element.count; ++i) {
      const auto [x, y, z, nx, ny, nz, u, v] = records_.vertex(i);
      mesh_.positions[i] = {x, y, z};
      if (!mesh_.normals.empty()) mesh_.normals[i] = {nx, ny, nz};
      if (!mesh_.texcoords.empty()) mesh_.texcoords[i] = {u, v};
    }
  }

  void read_faces(const PlyElement& element) {
    mesh_.triangles.reserve(element.count);
    for (std::uint32_t i = 0; i < element.count;) {
      const std::size_t before = mesh_.triangles.size();
      records_.numbers().pass(copy_ply_triangles(header_, layout_, rest(), element.count - i, mesh_));
      i += static_cast<std::uint32_t>(mesh_.triangles.size() - before);
      if (i < element.count) read_face(i++);
    }
  }

  /// A fan around the first corner.
  void read_face(std::uint32_t index) {
    std::uint32_t taken = 0, first = 0, last = 0;
    const auto corner = [&](std::uint32_t vertex) {
      if (taken == 0) first = vertex;
      if (taken >= 2) mesh_.triangles.push_back({first, last, vertex});
      last = vertex;
      ++taken;
    };
    records_.face(
        index, [&](std::uint32_t corners) { polygons_ += corners > 3; }, corner);
  }

  std::string_view rest() { return content_.substr(records_.numbers().offset()); }

  const PlyHeader& header_;
  const PlyLayout& layout_;
  std::string_view content_;
  PlyRecords records_;
  TriangleMesh mesh_;
  std::size_t polygons_ = 0, rounded_ = 0;
};

}  // namespace

TriangleMesh read_ply(std::string_view content, const std::filesystem::path& file, MeshNotes& notes) {
  const std::string name = file.string();
  TextCursor cursor(content, name);
  const PlyHeader header = parse_ply_header(cursor, content.size());
  if (header.format == PlyFormat::kText) return read_with_open_mesh(prepare_ply(content, name), file, notes);
  const PlyLayout layout = find_ply_layout(header, cursor);
  return BinaryPlyReader(header, layout, content, PlyNumbers(content, name, cursor, header.format)).read(notes);
}

}  // namespace plumb
