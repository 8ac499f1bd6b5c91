#include <cstring>
#include <string>
#include <string_view>

#include "meshes/formats/ply_records.h"
#include "meshes/formats/prepare.h"

namespace plumb {
namespace {

/// Under which names OpenMesh knows the numbers of a vertex.
constexpr std::array<std::string_view, kPlyVertexNumbers> kNames = {"x", "y", "z", "nx", "ny", "nz", "u", "v"};

std::string header_of(const PlyLayout& layout) {
  std::string out =
      "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(layout.vertex->count) + "\n";
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (layout.sources[i]) out.append("property float ").append(kNames[i]).append("\n");
  }
  return out + "element face " + std::to_string(layout.face == nullptr ? 0 : layout.face->count) +
         "\nproperty list int int vertex_indices\nend_header\n";
}

template <class Number>
void append(std::string& bytes, Number number) {
  char raw[sizeof number];
  std::memcpy(raw, &number, sizeof number);
  bytes.append(raw, sizeof raw);
}

void keep_vertex(PlyRecords& records, const PlyLayout& layout, std::uint32_t index, PreparedMesh& prepared) {
  const auto kept = records.vertex(index);
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (layout.sources[i]) append(prepared.bytes, kept[i]);
  }
}

void keep_face(PlyRecords& records, std::uint32_t index, PreparedMesh& prepared) {
  const auto begin = [&](std::uint32_t corners) {
    prepared.triangles += corners - 2;
    if (corners > 3) ++prepared.notes.polygons;
    append(prepared.bytes, corners);
  };
  records.face(index, begin, [&](std::uint32_t vertex) { append(prepared.bytes, vertex); });
}

}  // namespace

PreparedMesh prepare_ply(std::string_view content, const std::string& file) {
  TextCursor cursor(content, file);
  const PlyHeader header = parse_ply_header(cursor, content.size());
  const PlyLayout layout = find_ply_layout(header, cursor);
  PreparedMesh prepared;
  prepared.bytes = header_of(layout);
  prepared.binary = true;
  prepared.vertices = layout.vertex->count;
  prepared.faces = layout.face == nullptr ? 0 : layout.face->count;
  PlyRecords records(layout, PlyNumbers(content, file, cursor, header.format));
  for (const PlyElement& element : header.elements) {
    // Without properties there is nothing to walk through, whatever the count says.
    for (std::uint32_t i = 0; i < element.count && !element.properties.empty(); ++i) {
      if (&element == layout.vertex) {
        keep_vertex(records, layout, i, prepared);
      } else if (&element == layout.face) {
        keep_face(records, i, prepared);
      } else {
        records.skip(element, i);
      }
    }
  }
  records.numbers().expect_end();
  prepared.notes = ply_notes(header, layout, prepared.notes.polygons, records.rounded());
  return prepared;
}

}  // namespace plumb
