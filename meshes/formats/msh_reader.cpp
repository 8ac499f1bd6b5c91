#include "meshes/formats/msh_reader.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "meshes/formats/plain_number.h"
#include "meshes/formats/text_cursor.h"
#include "renderer/math/nearest_name.h"

namespace plumb {
namespace {

constexpr std::array<std::string_view, 4> kKeywords = {"vertices", "triangles", "texcoords", "normals"};
enum Section { kVertices, kTriangles, kTexcoords, kNormals };

/// Takes the plain numbers that come next, without a call for each. Between `hand_back` and `resume` the cursor, which
/// stands before the first number not taken, may be used.
class PlainNumbers {
 public:
  explicit PlainNumbers(TextCursor& cursor) : cursor_(cursor) { resume(); }

  /// False if the next number is not plain.
  bool take(double& value) {
    const char* const end = skip_space() ? take_plain_decimal(at_, value) : nullptr;
    if (end != nullptr) at_ = end;
    return end != nullptr;
  }
  /// Also false if the number is not below the limit.
  bool take_below(std::uint32_t limit, std::uint32_t& value) {
    const char* const end = skip_space() ? take_plain_whole(at_, value) : nullptr;
    const bool taken = end != nullptr && value < limit;
    if (taken) at_ = end;
    return taken;
  }

  void hand_back() { cursor_.take(static_cast<std::size_t>(at_ - begin_)); }
  void resume() {
    const std::string_view rest = cursor_.rest();
    begin_ = at_ = rest.data();
    end_ = begin_ + std::max<std::ptrdiff_t>(std::ssize(rest) - kPlainNumberReach, 0);
  }

 private:
  bool skip_space() {
    while (at_ < end_ && is_space(*at_)) ++at_;
    return at_ < end_;
  }

  TextCursor& cursor_;
  const char* begin_ = nullptr;
  const char* at_ = nullptr;
  const char* end_ = nullptr;  ///< from before here, kPlainNumberReach bytes are readable
};

class MshReader {
 public:
  MshReader(std::string_view text, const std::string& file) : cursor_(text, file) {}

  TriangleMesh read() {
    const std::uint32_t vertices = read_count("vertices");
    reserved_bytes_ = std::uint64_t{kBytesPerTriple} * vertices;
    const std::uint32_t triangles = read_count("triangles");
    mesh_.positions.resize(vertices);
    mesh_.triangles.resize(triangles);
    for (std::string_view word = cursor_.next(); !word.empty(); word = cursor_.next()) read_section(word);
    for (const Section needed : {kVertices, kTriangles}) {
      if (!seen_[needed])
        cursor_.fail_at_end("the file ends without the keyword " + quoted(kKeywords[needed]) +
                            "; expected it and its numbers");
    }
    return std::move(mesh_);
  }

 private:
  /// Three numbers of one digit, each with white space behind it.
  static constexpr std::uint32_t kBytesPerTriple = 6;

  std::uint32_t read_count(const std::string& of) {
    const std::string_view word = cursor_.next();
    if (word.empty()) {
      cursor_.fail_at_end((of == "vertices" ? "the file is empty" : "the file ends") +
                          std::string("; expected the number of ") + of);
    }
    const std::uint32_t count = cursor_.whole(word, "the number of " + of);
    // The last number may end the file, hence the 1.
    if (reserved_bytes_ + std::uint64_t{kBytesPerTriple} * count > cursor_.bytes_left() + 1) {
      cursor_.fail(word, std::to_string(count) + " " + of + " do not fit in the " +
                             std::to_string(cursor_.bytes_left()) + " bytes that follow; expected a number of " + of +
                             " that the file holds");
    }
    return count;
  }

  void read_section(std::string_view word) {
    const auto known = std::find(kKeywords.begin(), kKeywords.end(), word);
    if (known == kKeywords.end()) refuse_keyword(word);
    const auto section = static_cast<Section>(known - kKeywords.begin());
    if (seen_[section]) cursor_.fail(word, "a second " + quoted(word) + "; expected each keyword at most once");
    seen_[section] = true;
    last_section_ = section;
    const std::size_t vertices = mesh_.positions.size();  // proven to fit the file, so no list below is too long
    switch (section) {
      case kVertices:
        read_triples(mesh_.positions);
        break;
      case kTriangles:
        read_triangles();
        break;
      case kNormals:
        mesh_.normals.resize(vertices);
        read_triples(mesh_.normals);
        break;
      case kTexcoords:
        mesh_.texcoords.resize(vertices);
        read_texcoords();
    }
  }

  [[noreturn]] void refuse_keyword(std::string_view word) const {
    double number = 0;
    if (parse_number(word, number)) {
      const std::string after = last_section_ < 0 ? "the counts"
                                                  : "the last number of the " +
                                                        std::string(kKeywords[static_cast<std::size_t>(last_section_)]);
      cursor_.fail(word,
                   "the number " + quoted(word) + " follows " + after + "; expected a keyword or the end of the file");
    }
    const std::string_view nearest = nearest_name(word, kKeywords);
    const std::string expected = nearest.empty()
                                     ? "expected vertices, triangles, texcoords or normals, or the end of the file"
                                     : "expected " + quoted(nearest);
    cursor_.fail(word, quoted(word) + " is not a keyword; " + expected);
  }

  template <class Triple>
  void read_triples(std::vector<Triple>& triples) {
    const std::size_t total = 3 * triples.size();
    PlainNumbers plain(cursor_);
    for (std::size_t i = 0; i < triples.size(); ++i) {
      triples[i].x = read_number(plain, 3 * i, total);
      triples[i].y = read_number(plain, 3 * i + 1, total);
      triples[i].z = read_number(plain, 3 * i + 2, total);
    }
    plain.hand_back();
  }

  void read_texcoords() {
    const std::size_t total = 2 * mesh_.texcoords.size();
    PlainNumbers plain(cursor_);
    for (std::size_t i = 0; i < mesh_.texcoords.size(); ++i) {
      mesh_.texcoords[i].u = read_number(plain, 2 * i, total);
      mesh_.texcoords[i].v = read_number(plain, 2 * i + 1, total);
    }
    plain.hand_back();
  }

  void read_triangles() {
    const auto vertices = static_cast<std::uint32_t>(mesh_.positions.size());
    const std::size_t total = 3 * mesh_.triangles.size();
    PlainNumbers plain(cursor_);
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
      for (std::size_t corner = 0; corner < 3; ++corner) {
        std::uint32_t& index = mesh_.triangles[i][corner];
        if (plain.take_below(vertices, index)) continue;
        plain.hand_back();
        index = index_of_word(3 * i + corner, total);
        plain.resume();
      }
    }
    plain.hand_back();
  }

  double read_number(PlainNumbers& plain, std::size_t done, std::size_t total) {
    double value = 0;
    if (plain.take(value)) return value;
    plain.hand_back();
    value = number_of_word(done, total);
    plain.resume();
    return value;
  }

  double number_of_word(std::size_t done, std::size_t total) {
    const std::string_view word = cursor_.next();
    double value = 0;
    if (parse_number(word, value)) return value;
    if (word.empty()) end_early(done, total);
    return cursor_.number(word, progress(done, total));
  }

  std::uint32_t index_of_word(std::size_t done, std::size_t total) {
    const std::string_view word = cursor_.next();
    std::uint32_t index = 0;
    if (!parse_whole(word, index) || index >= mesh_.positions.size()) refuse_index(word, done, total);
    return index;
  }

  [[noreturn]] void refuse_index(std::string_view word, std::size_t done, std::size_t total) const {
    if (word.empty()) end_early(done, total);
    const std::size_t vertices = mesh_.positions.size();
    const std::string range = vertices == 0 ? "no index, the mesh has no vertices"
                                            : "a vertex index from 0 to " + std::to_string(vertices - 1);
    std::uint32_t index = 0;
    const std::string fault = parse_whole(word, index) ? " is out of range" : " is not a vertex index";
    cursor_.fail(word, quoted(word) + fault + "; expected " + range + " (" + progress(done, total) + ")");
  }

  [[noreturn]] void end_early(std::size_t done, std::size_t total) const {
    cursor_.fail_at_end("the file ends in the " + section_name() + ": " + std::to_string(done) + " of " +
                        std::to_string(total) + " numbers read");
  }

  std::string progress(std::size_t done, std::size_t total) const {
    return "number " + std::to_string(done + 1) + " of " + std::to_string(total) + " of the " + section_name();
  }

  std::string section_name() const { return std::string(kKeywords[static_cast<std::size_t>(last_section_)]); }

  TextCursor cursor_;
  TriangleMesh mesh_;
  std::uint64_t reserved_bytes_ = 0;
  std::array<bool, 4> seen_{};
  int last_section_ = -1;
};

}  // namespace

TriangleMesh read_msh(std::string_view text, const std::string& file, MeshNotes& notes) {
  const std::size_t line_end = text.find('\n');
  const bool is_crlf = line_end != std::string_view::npos && line_end > 0 && text[line_end - 1] == '\r';
  notes.format = is_crlf ? "MSH, text with CRLF" : "MSH, text";
  return MshReader(text, file).read();
}

}  // namespace plumb
