#include "meshes/formats/ply_layout.h"

#include <algorithm>
#include <string>
#include <string_view>

namespace plumb {
namespace {

/// The names that a vertex property goes by, in the order of the numbers.
constexpr std::array<std::array<std::string_view, 3>, kPlyVertexNumbers> kNames = {
    {{"x"}, {"y"}, {"z"}, {"nx"}, {"ny"}, {"nz"}, {"u", "s", "texture_u"}, {"v", "t", "texture_v"}}};

const PlyElement* find_element(const PlyHeader& header, std::string_view name) {
  const auto found =
      std::find_if(header.elements.begin(), header.elements.end(), [&](const PlyElement& e) { return e.name == name; });
  return found == header.elements.end() ? nullptr : &*found;
}

void find_sources(PlyLayout& layout, const TextCursor& cursor) {
  const PlyElement& vertex = *layout.vertex;
  auto& sources = layout.sources;
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    for (const std::string_view name : kNames[i]) {
      if (!name.empty() && !sources[i]) sources[i] = vertex.find(name);
    }
    if (sources[i] && vertex.properties[*sources[i]].count_type) {
      cursor.fail(vertex.properties[*sources[i]].name, "a list gives a coordinate; expected a number");
    }
  }
  if (!sources[0] || !sources[1] || !sources[2]) {
    cursor.fail(vertex.name, "the vertices have no x, y and z; expected all three");
  }
  if (!sources[3] || !sources[4] || !sources[5]) sources[3] = sources[4] = sources[5] = std::nullopt;
  if (!sources[6] || !sources[7]) sources[6] = sources[7] = std::nullopt;
}

void find_corners(PlyLayout& layout, const TextCursor& cursor) {
  const PlyElement* face = layout.face;
  if (face == nullptr || face->count == 0) return;
  layout.corners = face->find("vertex_indices");
  if (!layout.corners) layout.corners = face->find("vertex_index");
  if (!layout.corners || !face->properties[*layout.corners].count_type) {
    cursor.fail(face->name, "the faces have no list vertex_indices; expected one");
  }
}

/// The names of the properties that are not kept.
std::string names_left_out(const PlyElement& element, const PlyLayout& layout) {
  std::string names;
  for (std::size_t p = 0; p < element.properties.size(); ++p) {
    const bool kept = &element == layout.vertex ? layout.slot_of(p) < kPlyVertexNumbers : layout.corners == p;
    if (!kept) names.append(names.empty() ? "" : ", ").append(element.properties[p].name);
  }
  return names;
}

}  // namespace

std::size_t PlyLayout::slot_of(std::size_t property) const {
  return static_cast<std::size_t>(std::find(sources.begin(), sources.end(), std::optional(property)) - sources.begin());
}

PlyLayout find_ply_layout(const PlyHeader& header, const TextCursor& cursor) {
  PlyLayout layout;
  layout.vertex = find_element(header, "vertex");
  layout.face = find_element(header, "face");
  if (layout.vertex == nullptr || (layout.face != nullptr && layout.face < layout.vertex)) {
    cursor.fail_at_end("the header has no element vertex before its faces; expected one with x, y and z");
  }
  find_sources(layout, cursor);
  find_corners(layout, cursor);
  return layout;
}

MeshNotes ply_notes(const PlyHeader& header, const PlyLayout& layout, std::size_t polygons, std::size_t rounded) {
  MeshNotes notes;
  notes.polygons = polygons;
  notes.format = header.format == PlyFormat::kText           ? "PLY, text"
                 : header.format == PlyFormat::kLittleEndian ? "PLY, binary, little-endian"
                                                             : "PLY, binary, big-endian";
  for (const PlyElement& element : header.elements) {
    if (element.count == 0) continue;
    if (&element != layout.vertex && &element != layout.face) {
      notes.sentences.push_back("the element " + quoted(element.name) + ", of which there " +
                                (element.count == 1 ? "is " : "are ") + std::to_string(element.count) +
                                ", is not kept");
      continue;
    }
    if (const std::string names = names_left_out(element, layout); !names.empty()) {
      notes.sentences.push_back("of " +
                                (&element == layout.vertex ? counted(element.count, "vertex", "vertices")
                                                           : counted(element.count, "face", "faces")) +
                                ", these properties are not kept: " + names);
    }
  }
  if (rounded > 0) notes.sentences.push_back(rounding_note(rounded));
  return notes;
}

}  // namespace plumb
