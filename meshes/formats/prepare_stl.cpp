#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "meshes/formats/prepare.h"
#include "meshes/formats/text_cursor.h"
#include "renderer/math/input_error.h"
#include "renderer/math/nearest_name.h"

namespace plumb {
namespace {

constexpr std::size_t kHeaderBytes = 84;  // a free text of 80 bytes and the number of facets
constexpr std::size_t kFacetBytes = 50;   // normal, three corners, an attribute of two bytes

using Corners = std::array<std::array<float, 3>, 3>;

bool has_equal_corners(const Corners& c) { return c[0] == c[1] || c[1] == c[2] || c[2] == c[0]; }
constexpr const char* kDegenerate = "two corners of the facet are equal; expected three different points";

std::uint64_t binary_facets(const std::string& content) {
  std::uint64_t count = 0;
  for (std::size_t i = 4; i-- > 0;) count = count << 8 | static_cast<unsigned char>(content[80 + i]);
  return count;
}

PreparedMesh prepare_binary(const std::string& content, const std::string& file) {
  const std::uint64_t facets = binary_facets(content);
  for (std::uint64_t facet = 0; facet < facets; ++facet) {
    Corners corners;
    std::memcpy(&corners, content.data() + kHeaderBytes + facet * kFacetBytes + 12, sizeof corners);
    const std::string in_facet = "facet " + std::to_string(facet) + ": ";
    for (const auto& corner : corners) {
      for (const float x : corner) {
        if (!std::isfinite(x))
          throw InputError({file}, in_facet + "a coordinate is not finite; expected a finite number");
      }
    }
    if (has_equal_corners(corners)) throw InputError({file}, in_facet + kDegenerate);
  }
  return {content, facets, true};
}

class TextPreparer {
 public:
  TextPreparer(const std::string& content, const std::string& file) : cursor_(content, file) {}

  PreparedMesh prepare() {
    for (std::string_view word = cursor_.next(); !word.empty(); word = cursor_.next()) {
      if (!equal_ignoring_case(word, "solid"))
        cursor_.fail(word, quoted(word) + " stands here; expected solid or the end of the file");
      cursor_.next_line();  // the solid's name
      while (keep_facet()) ++prepared_.faces;
      cursor_.next_line();
    }
    return std::move(prepared_);
  }

 private:
  void expect(std::string_view keyword) {
    const std::string_view word = cursor_.next();
    if (equal_ignoring_case(word, keyword)) return;
    cursor_.fail(word, (word.empty() ? "the file ends" : quoted(word) + " stands here") + std::string("; expected ") +
                           std::string(keyword));
  }

  /// False at `endsolid`.
  bool keep_facet() {
    const std::string_view facet = cursor_.next();
    if (equal_ignoring_case(facet, "endsolid")) return false;
    if (!equal_ignoring_case(facet, "facet")) {
      cursor_.fail(facet, (facet.empty() ? "the file ends" : quoted(facet) + " stands here") +
                              std::string("; expected facet or endsolid"));
    }
    expect("normal");
    for (int i = 0; i < 3; ++i) cursor_.next();  // not used, and often nan
    expect("outer");
    expect("loop");
    prepared_.bytes += "outer loop\n";
    Corners corners;
    for (auto& corner : corners) {
      expect("vertex");
      prepared_.bytes += "vertex";
      for (float& x : corner) {
        const std::string_view word = cursor_.next();
        x = static_cast<float>(cursor_.single(word, "three coordinates of a corner"));
        prepared_.bytes.append(" ").append(word);
      }
      prepared_.bytes += '\n';
    }
    if (has_equal_corners(corners)) cursor_.fail(facet, kDegenerate);
    prepared_.bytes += "endloop\n";
    expect("endloop");
    expect("endfacet");
    return true;
  }

  TextCursor cursor_;
  PreparedMesh prepared_;
};

}  // namespace

PreparedMesh prepare_stl(const std::string& content, const std::string& file) {
  if (content.size() >= kHeaderBytes && content.size() == kHeaderBytes + kFacetBytes * binary_facets(content)) {
    return prepare_binary(content, file);
  }
  TextCursor cursor(content, file);
  if (equal_ignoring_case(cursor.next(), "solid")) return TextPreparer(content, file).prepare();
  if (content.size() < kHeaderBytes)
    throw InputError({file}, "neither STL text nor binary STL; expected solid or a header of 84 bytes");
  throw InputError({file}, std::to_string(binary_facets(content)) + " facets do not fit the file's " +
                               std::to_string(content.size()) +
                               " bytes; expected 84 and 50 for each facet, or STL text");
}

}  // namespace plumb
