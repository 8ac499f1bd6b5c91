// Not through OpenMesh: its STL reader joins points that are closer than the smallest normal float, drops facets with
// two such corners, and holds every point in a map.
#include "meshes/formats/stl_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include "meshes/formats/point_joiner.h"
#include "meshes/formats/text_cursor.h"
#include "renderer/math/input_error.h"
#include "renderer/math/nearest_name.h"

namespace plumb {
namespace {

constexpr std::size_t kHeaderBytes = 84;  // a free text of 80 bytes and the number of facets
constexpr std::size_t kFacetBytes = 50;   // normal, three corners, an attribute of two bytes

using Triple = std::array<float, 3>;
using Corners = std::array<Triple, 3>;

/// The mesh so far, and what is left out of it.
class Facets {
 public:
  explicit Facets(const std::string& file) : file_(file), joiner_(mesh_.positions) {}

  void reserve(std::size_t facets) { mesh_.triangles.reserve(facets); }
  void add(const Corners& corners) {
    if (mesh_.triangles.size() >= std::numeric_limits<std::int32_t>::max() / 3)
      throw InputError({file_}, "more than 715827882 facets; expected fewer");
    auto& triangle = mesh_.triangles.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) triangle[i] = joiner_.vertex_at(corners[i]);
  }
  std::size_t count() const { return mesh_.triangles.size(); }

  TriangleMesh finish(MeshNotes& notes) {
    if (count() > 0) {
      notes.sentences.push_back(std::to_string(3 * count()) + " corners are joined to " +
                                counted(mesh_.positions.size(), "vertex", "vertices") + ", those at equal points");
    }
    if (normals > 0) notes.sentences.push_back("normals of " + counted(normals, "facet", "facets") + " are not kept");
    return std::move(mesh_);
  }

  /// How many facets have a normal that is not just zeros.
  std::size_t normals = 0;

 private:
  const std::string& file_;
  TriangleMesh mesh_;
  PointJoiner joiner_;
};

std::uint64_t binary_facets(const std::string& content) {
  std::uint64_t count = 0;
  for (std::size_t i = 4; i-- > 0;) count = count << 8 | static_cast<unsigned char>(content[80 + i]);
  return count;
}

TriangleMesh read_binary(const std::string& content, const std::string& file, MeshNotes& notes) {
  const std::uint64_t count = binary_facets(content);
  Facets facets(file);
  facets.reserve(count);
  std::size_t attributes = 0;
  for (std::uint64_t facet = 0; facet < count; ++facet) {
    struct {
      Triple normal;
      Corners corners;
    } numbers;
    const char* const bytes = content.data() + kHeaderBytes + facet * kFacetBytes;
    std::memcpy(&numbers, bytes, sizeof numbers);
    for (const Triple& corner : numbers.corners) {
      for (const float x : corner) {
        if (!std::isfinite(x)) {
          throw InputError({file},
                           "facet " + std::to_string(facet) + ": a coordinate is not finite; expected a finite number");
        }
      }
    }
    if (numbers.normal != Triple{}) ++facets.normals;
    if (bytes[48] != 0 || bytes[49] != 0) ++attributes;
    facets.add(numbers.corners);
  }
  notes.format = "STL, binary";
  TriangleMesh mesh = facets.finish(notes);
  if (attributes > 0) {
    notes.sentences.push_back("the attribute bytes of " + counted(attributes, "facet", "facets") + " are not kept");
  }
  return mesh;
}

class TextReader {
 public:
  TextReader(const std::string& content, const std::string& file) : cursor_(content, file), facets_(file) {}

  TriangleMesh read(MeshNotes& notes) {
    for (std::string_view word = cursor_.next(); !word.empty(); word = cursor_.next()) {
      if (!equal_ignoring_case(word, "solid"))
        cursor_.fail(word, quoted(word) + " stands here; expected solid or the end of the file");
      ++solids_;
      cursor_.next_line();  // the solid's name
      while (read_facet()) {
      }
      cursor_.next_line();
    }
    notes.format = "STL, text";
    TriangleMesh mesh = facets_.finish(notes);
    if (solids_ > 1) notes.sentences.push_back(std::to_string(solids_) + " solids become one mesh");
    if (cursor_.rounded() > 0) notes.sentences.push_back(rounding_note(cursor_.rounded()));
    return mesh;
  }

 private:
  void expect(std::string_view keyword) {
    const std::string_view word = cursor_.next();
    if (equal_ignoring_case(word, keyword)) return;
    cursor_.fail(word, (word.empty() ? "the file ends" : quoted(word) + " stands here") + std::string("; expected ") +
                           std::string(keyword));
  }

  /// False at `endsolid`.
  bool read_facet() {
    const std::string_view facet = cursor_.next();
    if (equal_ignoring_case(facet, "endsolid")) return false;
    if (!equal_ignoring_case(facet, "facet")) {
      cursor_.fail(facet, (facet.empty() ? "the file ends" : quoted(facet) + " stands here") +
                              std::string("; expected facet or endsolid"));
    }
    expect("normal");
    bool has_normal = false;
    for (int i = 0; i < 3; ++i) {
      double x = 0;
      if (!parse_number(cursor_.next(), x) || x != 0) has_normal = true;  // often nan
    }
    if (has_normal) ++facets_.normals;
    expect("outer");
    expect("loop");
    Corners corners;
    for (Triple& corner : corners) {
      expect("vertex");
      for (float& x : corner) x = cursor_.single(cursor_.next(), "three coordinates of a corner");
    }
    expect("endloop");
    expect("endfacet");
    facets_.add(corners);
    return true;
  }

  TextCursor cursor_;
  Facets facets_;
  std::size_t solids_ = 0;
};

}  // namespace

TriangleMesh read_stl(const std::string& content, const std::string& file, MeshNotes& notes) {
  if (content.size() >= kHeaderBytes && content.size() == kHeaderBytes + kFacetBytes * binary_facets(content)) {
    return read_binary(content, file, notes);
  }
  TextCursor cursor(content, file);
  if (equal_ignoring_case(cursor.next(), "solid")) return TextReader(content, file).read(notes);
  if (content.size() < kHeaderBytes)
    throw InputError({file}, "neither STL text nor binary STL; expected solid or a header of 84 bytes");
  throw InputError({file}, std::to_string(binary_facets(content)) + " facets do not fit the file's " +
                               std::to_string(content.size()) +
                               " bytes; expected 84 and 50 for each facet, or STL text");
}

}  // namespace plumb
