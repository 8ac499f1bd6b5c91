#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>
#include <vector>

#include "meshes/formats/prepare.h"
#include "meshes/formats/text_cursor.h"

namespace plumb {
namespace {

/// The three lists that a corner `v/vt/vn` points into.
constexpr std::array<std::string_view, 3> kLists = {"v", "vt", "vn"};
constexpr std::array<std::string_view, 3> kNames = {"vertex", "texture coordinate", "normal"};
/// How many numbers each entry has; more may follow (weights, colours) and are left out.
constexpr std::array<int, 3> kNumbers = {3, 2, 3};

class ObjPreparer {
 public:
  ObjPreparer(const std::string& content, const std::string& file) : content_(content), file_(file) {}

  PreparedMesh prepare() {
    for_each_statement([this](TextCursor&, std::string_view keyword) {
      if (const int list = list_of(keyword); list >= 0) ++totals_[static_cast<std::size_t>(list)];
    });
    for_each_statement([this](TextCursor& cursor, std::string_view keyword) {
      if (const int list = list_of(keyword); list >= 0) keep_entry(cursor, static_cast<std::size_t>(list));
      if (keyword == "f") keep_face(cursor, keyword);
    });
    return std::move(prepared_);
  }

 private:
  template <class Visit>
  void for_each_statement(Visit visit) {
    TextCursor cursor(content_, file_);
    do {
      const std::string_view keyword = cursor.next_in_line('#');
      if (!keyword.empty()) visit(cursor, keyword);
    } while (cursor.next_line());
  }

  static int list_of(std::string_view keyword) {
    const auto found = std::find(kLists.begin(), kLists.end(), keyword);
    return found == kLists.end() ? -1 : static_cast<int>(found - kLists.begin());
  }

  void keep_entry(TextCursor& cursor, std::size_t list) {
    ++so_far_[list];
    prepared_.bytes += kLists[list];
    std::string_view word = cursor.next_in_line('#');
    for (int i = 0; !word.empty() || i < kNumbers[list]; ++i, word = cursor.next_in_line('#')) {
      cursor.single(word, list == 1   ? "two numbers of a texture coordinate"
                          : list == 0 ? "three coordinates of a vertex"
                                      : "three numbers of a normal");
      if (i < kNumbers[list]) prepared_.bytes.append(" ").append(word);
    }
    prepared_.bytes += '\n';
  }

  void keep_face(TextCursor& cursor, std::string_view keyword) {
    prepared_.bytes += 'f';
    vertices_.clear();
    for (std::string_view word = cursor.next_in_line('#'); !word.empty(); word = cursor.next_in_line('#'))
      keep_corner(cursor, word);
    if (vertices_.size() < 3) {
      cursor.fail(keyword, "a face of " + std::to_string(vertices_.size()) + " corners; expected three or more");
    }
    std::sort(vertices_.begin(), vertices_.end());
    if (const auto twice = std::adjacent_find(vertices_.begin(), vertices_.end()); twice != vertices_.end()) {
      cursor.fail(keyword, "the face has vertex " + std::to_string(*twice) + " twice; expected different corners");
    }
    prepared_.bytes += '\n';
    ++prepared_.faces;
  }

  /// A corner is `v`, `v/vt`, `v//vn` or `v/vt/vn`.
  void keep_corner(TextCursor& cursor, std::string_view word) {
    prepared_.bytes += ' ';
    std::string_view rest = word;
    for (std::size_t list = 0; list < 3; ++list) {
      const std::size_t slash = rest.find('/');
      const std::string_view part = rest.substr(0, slash);
      if (part.empty() && (list != 1 || slash == std::string_view::npos)) {
        cursor.fail(part, "the corner " + quoted(word) + " has no " + std::string(kNames[list]) +
                              "; expected v, v/vt, v//vn or v/vt/vn");
      }
      if (!part.empty()) {
        const long long index = resolve(cursor, part, list);
        prepared_.bytes += std::to_string(index);
        if (list == 0) vertices_.push_back(index);
      }
      if (slash == std::string_view::npos) return;
      if (list < 2) prepared_.bytes += '/';
      rest.remove_prefix(slash + 1);
    }
    cursor.fail(word, "the corner " + quoted(word) + " has more than three parts; expected v, v/vt, v//vn or v/vt/vn");
  }

  /// The index counted from 1; a negative one in the file counts back from the last entry so far.
  long long resolve(TextCursor& cursor, std::string_view part, std::size_t list) const {
    const std::string expected = "; expected the index of a " + std::string(kNames[list]) + ", of which there are " +
                                 std::to_string(totals_[list]);
    long long index = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), index);
    if (error == std::errc::invalid_argument || end != part.data() + part.size()) {
      cursor.fail(part, quoted(part) + " is not a whole number" + expected);
    }
    const long long resolved = index < 0 ? so_far_[list] + 1 + index : index;
    if (error != std::errc() || resolved < 1 || resolved > totals_[list]) {
      cursor.fail(part, quoted(part) + " is out of range" + expected);
    }
    return resolved;
  }

  const std::string& content_;
  const std::string& file_;
  std::array<long long, 3> totals_{}, so_far_{};
  std::vector<long long> vertices_;
  PreparedMesh prepared_;
};

}  // namespace

PreparedMesh prepare_obj(const std::string& content, const std::string& file) {
  return ObjPreparer(content, file).prepare();
}

}  // namespace plumb
