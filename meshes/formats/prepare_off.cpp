#include <cmath>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <utility>
#include <vector>

#include "meshes/formats/prepare.h"
#include "meshes/formats/text_cursor.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

/// What the first word, [ST][C][N]OFF, says about the numbers of a vertex.
struct OffHeader {
  bool texcoords = false, colors = false, normals = false;
  std::size_t numbers() const { return 3 + (normals ? 3u : 0u) + (texcoords ? 2u : 0u); }
};

bool take(std::string_view& word, std::string_view prefix) {
  if (!word.starts_with(prefix)) return false;
  word.remove_prefix(prefix.size());
  return true;
}

OffHeader parse_header(const TextCursor& cursor, std::string_view word) {
  OffHeader header;
  std::string_view rest = word;
  header.texcoords = take(rest, "ST");
  header.colors = take(rest, "C");
  header.normals = take(rest, "N");
  if (rest != "OFF")
    cursor.fail(word, quoted(word) +
                          " opens the file; expected OFF, NOFF, COFF, STOFF or their combinations in three dimensions");
  return header;
}

class OffText {
 public:
  OffText(TextCursor cursor, OffHeader header) : cursor_(std::move(cursor)), header_(header) {}

  PreparedMesh prepare() {
    const std::string_view vertex_word = next_line_word();
    const std::uint32_t vertices = cursor_.whole(vertex_word, "the number of vertices");
    const std::string_view face_word = cursor_.next_in_line('#');
    const std::uint32_t faces = cursor_.whole(face_word, "the number of faces");
    cursor_.whole(cursor_.next_in_line('#'), "the number of edges");
    end_of_line("the end of the line");
    need_bytes(vertex_word, "vertices", 2 * header_.numbers() * std::uint64_t{vertices});
    need_bytes(face_word, "faces", 2 * header_.numbers() * std::uint64_t{vertices} + 8 * std::uint64_t{faces});
    prepared_.bytes.reserve(cursor_.bytes_left() + 64);
    prepared_.bytes = "OFF\n" + std::to_string(vertices) + " " + std::to_string(faces) + " 0\n";
    for (std::uint32_t i = 0; i < vertices; ++i) keep_vertex(i, vertices);
    for (std::uint32_t i = 0; i < faces; ++i) keep_face(i, faces, vertices);
    if (const std::string_view word = next_line_word(); !word.empty())
      cursor_.fail(word, quoted(word) + " follows the last face; expected the end of the file");
    prepared_.vertices = vertices;
    prepared_.faces = faces;
    note();
    return std::move(prepared_);
  }

 private:
  void note() {
    prepared_.notes.format = "OFF, text";
    auto& sentences = prepared_.notes.sentences;
    if (colored_vertices_ > 0) {
      sentences.push_back("colours, or other further numbers, of " + counted(colored_vertices_, "vertex", "vertices") +
                          " are not kept");
    }
    if (colored_faces_ > 0)
      sentences.push_back("colours of " + counted(colored_faces_, "face", "faces") + " are not kept");
    if (cursor_.rounded() > 0) sentences.push_back(rounding_note(cursor_.rounded()));
  }

  /// The first word of the next line that has one; empty at the end of the file.
  std::string_view next_line_word() {
    std::string_view word = cursor_.next_in_line('#');
    while (word.empty() && cursor_.next_line()) word = cursor_.next_in_line('#');
    return word;
  }

  void end_of_line(const std::string& expected) {
    if (const std::string_view word = cursor_.next_in_line('#'); !word.empty())
      cursor_.fail(word, quoted(word) + " stands here; expected " + expected);
  }

  void need_bytes(std::string_view word, const char* what, std::uint64_t bytes) const {
    if (bytes > cursor_.bytes_left() + 1) {
      cursor_.fail(word, std::string(word) + " " + what + " do not fit in the " + std::to_string(cursor_.bytes_left()) +
                             " bytes that follow; expected a number that the file holds");
    }
  }

  [[noreturn]] void ends_early(const char* what, std::uint32_t done, std::uint32_t total) const {
    cursor_.fail_at_end(std::string("the file ends in the ") + what + ": " + std::to_string(done) + " of " +
                        std::to_string(total) + " read");
  }

  /// x y z [normal] [colour] [u v], one vertex a line.
  void keep_vertex(std::uint32_t done, std::uint32_t total) {
    std::string_view word = next_line_word();
    if (word.empty()) ends_early("vertices", done, total);
    words_.clear();
    for (; !word.empty(); word = cursor_.next_in_line('#')) {
      cursor_.single(word, "the numbers of a vertex");
      words_.push_back(word);
    }
    if (words_.size() < header_.numbers())
      cursor_.single(word, std::to_string(header_.numbers()) + " numbers of a vertex");
    if (words_.size() > header_.numbers()) ++colored_vertices_;
    const std::size_t front = header_.normals ? 6 : 3;
    for (std::size_t i = 0; i < words_.size(); ++i) {
      const bool is_texcoord = header_.texcoords && i + 2 >= words_.size();
      if (i < front || is_texcoord) prepared_.bytes.append(i == 0 ? "" : " ").append(words_[i]);
    }
    prepared_.bytes += '\n';
  }

  /// The number of corners, their vertices, and a colour that is left out.
  void keep_face(std::uint32_t done, std::uint32_t total, std::uint32_t vertices) {
    const std::string_view word = next_line_word();
    if (word.empty()) ends_early("faces", done, total);
    const std::uint32_t corners = cursor_.whole(word, "the number of corners");
    if (corners < 3) cursor_.fail(word, "a face of " + std::to_string(corners) + " corners; expected three or more");
    prepared_.bytes += std::to_string(corners);
    prepared_.triangles += corners - 2;
    if (corners > 3) ++prepared_.notes.polygons;
    for (std::uint32_t i = 0; i < corners; ++i) {
      const std::string_view corner = cursor_.next_in_line('#');
      const std::uint32_t index = cursor_.whole(corner, "a vertex index");
      if (index >= vertices)
        cursor_.fail(corner, quoted(corner) + " is out of range; expected the index of one of " +
                                 std::to_string(vertices) + " vertices");
      prepared_.bytes.append(" ").append(std::to_string(index));
    }
    std::string_view rest = cursor_.next_in_line('#');
    if (!rest.empty()) ++colored_faces_;
    for (; !rest.empty(); rest = cursor_.next_in_line('#')) cursor_.number(rest, "a colour or the end of the line");
    prepared_.bytes += '\n';
  }

  TextCursor cursor_;
  OffHeader header_;
  std::vector<std::string_view> words_;
  std::size_t colored_vertices_ = 0, colored_faces_ = 0;
  PreparedMesh prepared_;
};

/// Checks the little-endian numbers behind the first line; the bytes stay as they are, and in the content.
class OffBinary {
 public:
  OffBinary(const std::string& content, const std::string& file, std::size_t offset)
      : content_(content), file_(file), offset_(offset) {}

  PreparedMesh prepare(OffHeader header) {
    const std::uint32_t vertices = next<std::uint32_t>(), faces = next<std::uint32_t>();
    next<std::uint32_t>();  // edges
    const std::uint64_t needed = 4 * header.numbers() * std::uint64_t{vertices} + 16 * std::uint64_t{faces};
    if (needed > content_.size() - offset_) {
      fail(std::to_string(vertices) + " vertices and " + std::to_string(faces) + " faces do not fit in the " +
           std::to_string(content_.size() - offset_) +
           " bytes that follow; expected little-endian numbers that the file holds");
    }
    for (std::uint64_t i = 0; i < vertices * header.numbers(); ++i) {
      if (!std::isfinite(next<float>()))
        fail("a number of vertex " + std::to_string(i / header.numbers()) + " is not finite; expected finite numbers");
    }
    PreparedMesh prepared;
    for (std::uint32_t face = 0; face < faces; ++face) {
      const std::uint32_t corners = next<std::uint32_t>();
      if (corners < 3)
        fail("face " + std::to_string(face) + " has " + std::to_string(corners) + " corners; expected three or more");
      prepared.triangles += corners - 2;
      if (corners > 3) ++prepared.notes.polygons;
      for (std::uint32_t i = 0; i < corners; ++i) {
        if (const std::uint32_t index = next<std::uint32_t>(); index >= vertices) {
          fail("face " + std::to_string(face) + " names vertex " + std::to_string(index) +
               "; expected the index of one of " + std::to_string(vertices) + " vertices");
        }
      }
    }
    if (offset_ != content_.size())
      fail(std::to_string(content_.size() - offset_) + " bytes follow the last face; expected the end of the file");
    prepared.vertices = vertices;
    prepared.faces = faces;
    prepared.binary = true;
    prepared.notes.format = "OFF, binary, little-endian";
    return prepared;
  }

 private:
  template <class Number>
  Number next() {
    if (content_.size() - offset_ < sizeof(Number))
      fail("the file ends within its numbers; expected as many as its counts say");
    Number value;
    std::memcpy(&value, content_.data() + offset_, sizeof value);
    offset_ += sizeof value;
    return value;
  }

  [[noreturn]] void fail(const std::string& what) const { throw InputError({file_}, what); }

  const std::string& content_;
  const std::string& file_;
  std::size_t offset_;
};

}  // namespace

PreparedMesh prepare_off(std::string&& content, const std::string& file) {
  TextCursor cursor(content, file);
  const OffHeader header = parse_header(cursor, cursor.next_in_line());
  TextCursor ahead = cursor;
  const std::string_view variant = ahead.next_in_line('#');
  if (variant != "BINARY") return OffText(cursor, header).prepare();
  if (header.colors)
    cursor.fail(variant, "binary OFF with colours has no agreed layout; expected OFF, NOFF, STOFF or STNOFF");
  ahead.next_line();
  PreparedMesh prepared = OffBinary(content, file, ahead.position()).prepare(header);
  prepared.bytes = std::move(content);
  return prepared;
}

}  // namespace plumb
