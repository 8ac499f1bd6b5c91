#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>
#include <utility>

#include "meshes/formats/ply_header.h"
#include "meshes/formats/ply_numbers.h"
#include "meshes/formats/prepare.h"

namespace plumb {
namespace {

/// The names that a vertex property goes by, in the order in which they are written.
constexpr std::array<std::array<std::string_view, 3>, 8> kNames = {
    {{"x"}, {"y"}, {"z"}, {"nx"}, {"ny"}, {"nz"}, {"u", "s", "texture_u"}, {"v", "t", "texture_v"}}};

class PlyPreparer {
 public:
  PlyPreparer(const PlyHeader& header, const TextCursor& at_header, PlyNumbers numbers)
      : header_(header), cursor_(at_header), numbers_(std::move(numbers)) {}

  PreparedMesh prepare() {
    const PlyElement* vertex = find_element("vertex");
    const PlyElement* face = find_element("face");
    if (vertex == nullptr || (face != nullptr && face < vertex)) {
      cursor_.fail_at_end("the header has no element vertex before its faces; expected one with x, y and z");
    }
    vertices_ = vertex->count;
    prepared_.vertices = vertices_;
    find_sources(*vertex, face);
    write_header(face == nullptr ? 0 : face->count);
    for (const PlyElement& element : header_.elements) {
      // Without properties there is nothing to walk through, whatever the count says.
      for (std::uint32_t i = 0; i < element.count && !element.properties.empty(); ++i) {
        if (&element == vertex) {
          keep_vertex(element, i);
        } else if (&element == face) {
          keep_face(element, i);
        } else {
          for (const PlyProperty& property : element.properties) skip(property, element, i);
        }
      }
    }
    numbers_.expect_end();
    note(vertex, face);
    return std::move(prepared_);
  }

 private:
  void note(const PlyElement* vertex, const PlyElement* face) {
    MeshNotes& notes = prepared_.notes;
    notes.format = header_.format == PlyFormat::kText           ? "PLY, text"
                   : header_.format == PlyFormat::kLittleEndian ? "PLY, binary, little-endian"
                                                                : "PLY, binary, big-endian";
    for (const PlyElement& element : header_.elements) {
      if (element.count == 0) continue;
      if (&element != vertex && &element != face) {
        notes.sentences.push_back("the element " + quoted(element.name) + ", of which there " +
                                  (element.count == 1 ? "is " : "are ") + std::to_string(element.count) +
                                  ", is not kept");
        continue;
      }
      std::string names;
      for (std::size_t p = 0; p < element.properties.size(); ++p) {
        const bool kept = &element == vertex
                              ? std::find(sources_.begin(), sources_.end(), std::optional(p)) != sources_.end()
                              : corners_ == p;
        if (!kept) names.append(names.empty() ? "" : ", ").append(element.properties[p].name);
      }
      if (!names.empty()) {
        notes.sentences.push_back("of " +
                                  (&element == vertex ? counted(element.count, "vertex", "vertices")
                                                      : counted(element.count, "face", "faces")) +
                                  ", these properties are not kept: " + names);
      }
    }
    if (rounded_ > 0) notes.sentences.push_back(rounding_note(rounded_));
  }

  const PlyElement* find_element(std::string_view name) const {
    const auto found = std::find_if(header_.elements.begin(), header_.elements.end(),
                                    [&](const PlyElement& e) { return e.name == name; });
    return found == header_.elements.end() ? nullptr : &*found;
  }

  /// Notes which property has each of the names, and which list has the corners.
  void find_sources(const PlyElement& vertex, const PlyElement* face) {
    for (std::size_t i = 0; i < kNames.size(); ++i) {
      for (const std::string_view name : kNames[i]) {
        if (!name.empty() && !sources_[i]) sources_[i] = vertex.find(name);
      }
      if (sources_[i] && vertex.properties[*sources_[i]].count_type) {
        cursor_.fail(vertex.properties[*sources_[i]].name, "a list gives a coordinate; expected a number");
      }
    }
    if (!sources_[0] || !sources_[1] || !sources_[2]) {
      cursor_.fail(vertex.name, "the vertices have no x, y and z; expected all three");
    }
    if (!sources_[3] || !sources_[4] || !sources_[5]) sources_[3] = sources_[4] = sources_[5] = std::nullopt;
    if (!sources_[6] || !sources_[7]) sources_[6] = sources_[7] = std::nullopt;
    if (face == nullptr || face->count == 0) return;
    corners_ = face->find("vertex_indices");
    if (!corners_) corners_ = face->find("vertex_index");
    if (!corners_ || !face->properties[*corners_].count_type) {
      cursor_.fail(face->name, "the faces have no list vertex_indices; expected one");
    }
  }

  void write_header(std::uint32_t faces) {
    std::string& out = prepared_.bytes;
    out = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(vertices_) + "\n";
    for (std::size_t i = 0; i < kNames.size(); ++i) {
      if (sources_[i]) out.append("property float ").append(kNames[i][0]).append("\n");
    }
    out += "element face " + std::to_string(faces) + "\nproperty list int int vertex_indices\nend_header\n";
    prepared_.faces = faces;
    prepared_.binary = true;
  }

  void keep_vertex(const PlyElement& element, std::uint32_t vertex) {
    std::array<float, 8> kept{};
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      const auto slot = std::find(sources_.begin(), sources_.end(), std::optional(p));
      if (slot == sources_.end()) {
        skip(property, element, vertex);
        continue;
      }
      const float value = static_cast<float>(numbers_.next(property.type));
      if (!std::isfinite(value)) {
        numbers_.fail(std::string(property.name) + " of vertex " + std::to_string(vertex) +
                      " is not finite; expected a finite number of single precision");
      }
      if (numbers_.is_rounded_to(value)) ++rounded_;
      kept[static_cast<std::size_t>(slot - sources_.begin())] = value;
    }
    for (std::size_t i = 0; i < kept.size(); ++i) {
      if (sources_[i]) append(kept[i]);
    }
  }

  void keep_face(const PlyElement& element, std::uint32_t face) {
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      if (p != corners_) {
        skip(property, element, face);
        continue;
      }
      const std::uint32_t corners = whole(*property.count_type, element, face, "the number of corners");
      if (corners < 3) {
        numbers_.fail("face " + std::to_string(face) + " has " + std::to_string(corners) +
                      " corners; expected three or more");
      }
      prepared_.triangles += corners - 2;
      if (corners > 3) ++prepared_.notes.polygons;
      append(corners);
      for (std::uint32_t i = 0; i < corners; ++i) {
        const std::uint32_t index = whole(property.type, element, face, "a vertex index");
        if (index >= vertices_) {
          numbers_.fail("face " + std::to_string(face) + " names vertex " + std::to_string(index) +
                        "; expected the index of one of " + std::to_string(vertices_) + " vertices");
        }
        append(index);
      }
    }
  }

  void skip(const PlyProperty& property, const PlyElement& element, std::uint32_t instance) {
    std::uint32_t numbers = 1;
    if (property.count_type) numbers = whole(*property.count_type, element, instance, "the length of a list");
    for (; numbers > 0; --numbers) numbers_.next(property.type);
  }

  /// The next number, which must be one that an int can hold: OpenMesh reads no other.
  std::uint32_t whole(PlyType type, const PlyElement& element, std::uint32_t instance, const char* what) {
    const double number = numbers_.next(type);
    if (!(number >= 0 && number <= 0x7fffffff && number == std::floor(number))) {
      numbers_.fail(std::string(element.name) + " " + std::to_string(instance) + ": " + what +
                    " is wrong; expected a whole number from 0 to 2147483647");
    }
    return static_cast<std::uint32_t>(number);
  }

  template <class Number>
  void append(Number number) {
    char raw[sizeof number];
    std::memcpy(raw, &number, sizeof number);
    prepared_.bytes.append(raw, sizeof raw);
  }

  const PlyHeader& header_;
  const TextCursor& cursor_;
  PlyNumbers numbers_;
  std::uint32_t vertices_ = 0;
  std::size_t rounded_ = 0;
  std::array<std::optional<std::size_t>, 8> sources_;
  std::optional<std::size_t> corners_;
  PreparedMesh prepared_;
};

}  // namespace

PreparedMesh prepare_ply(const std::string& content, const std::string& file) {
  TextCursor cursor(content, file);
  const PlyHeader header = parse_ply_header(cursor, content.size());
  return PlyPreparer(header, cursor, PlyNumbers(content, file, cursor, header.format)).prepare();
}

}  // namespace plumb
