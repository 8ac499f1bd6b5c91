#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <string_view>
#include <vector>

#include "meshes/formats/prepare.h"
#include "meshes/formats/text_cursor.h"

namespace plumb {
namespace {

/// The three lists that a corner `v/vt/vn` points into.
constexpr std::array<std::string_view, 3> kLists = {"v", "vt", "vn"};
constexpr std::array<std::string_view, 3> kNames = {"vertex", "texture coordinate", "normal"};
constexpr std::array<std::string_view, 3> kPlurals = {"vertices", "texture coordinates", "normals"};
/// How many numbers each entry has; more may follow (weights, colours) and are left out.
constexpr std::array<int, 3> kNumbers = {3, 2, 3};
/// Of a face. OpenMesh compares each corner with all others, so that a file of one face would take time with the square
/// of its length: 7 seconds for 262 KB, under the sanitizers.
constexpr std::size_t kMostCorners = 1000;

std::string counted_of(std::size_t count, std::size_t list) {
  return counted(count, std::string(kNames[list]), std::string(kPlurals[list]));
}

class ObjPreparer {
 public:
  ObjPreparer(const std::string& content, const std::string& file) : content_(content), file_(file) {}

  PreparedMesh prepare() {
    for_each_statement([this](TextCursor&, std::string_view keyword) {
      if (const int list = list_of(keyword); list >= 0) ++totals_[static_cast<std::size_t>(list)];
    });
    // Whole numbers may be written longer than in the file, where they count back.
    prepared_.bytes.reserve(content_.size() + content_.size() / 16);
    prepared_.vertices = static_cast<std::size_t>(totals_[0]);
    face_of_.resize(prepared_.vertices);
    for (std::size_t list = 1; list < 3; ++list) used_[list].resize(static_cast<std::size_t>(totals_[list]));
    for_each_statement([this](TextCursor& cursor, std::string_view keyword) {
      if (const int list = list_of(keyword); list >= 0) {
        keep_entry(cursor, static_cast<std::size_t>(list));
      } else if (keyword == "f") {
        keep_face(cursor, keyword);
      } else {
        leave_out(keyword);
      }
    });
    for (std::size_t i = 0; i < prepared_.stand_ins.size(); ++i) prepared_.bytes += "v 0 0 0\n";
    note();
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
    rounded_ = cursor.rounded();
  }

  static int list_of(std::string_view keyword) {
    const auto found = std::find(kLists.begin(), kLists.end(), keyword);
    return found == kLists.end() ? -1 : static_cast<int>(found - kLists.begin());
  }

  void keep_entry(TextCursor& cursor, std::size_t list) {
    ++so_far_[list];
    prepared_.bytes += kLists[list];
    std::string_view word = cursor.next_in_line('#');
    int i = 0;
    for (; !word.empty() || i < kNumbers[list]; ++i, word = cursor.next_in_line('#')) {
      cursor.single(word, list == 1   ? "two numbers of a texture coordinate"
                          : list == 0 ? "three coordinates of a vertex"
                                      : "three numbers of a normal");
      if (i < kNumbers[list]) prepared_.bytes.append(" ").append(word);
    }
    if (i > kNumbers[list]) ++longer_[list];
    prepared_.bytes += '\n';
  }

  void keep_face(TextCursor& cursor, std::string_view keyword) {
    prepared_.bytes += 'f';
    ++prepared_.faces;
    std::size_t corners = 0;
    for (std::string_view word = cursor.next_in_line('#'); !word.empty(); word = cursor.next_in_line('#'), ++corners) {
      if (corners == kMostCorners)
        cursor.fail(keyword,
                    "a face of more than " + std::to_string(kMostCorners) + " corners; expected at most that many");
      keep_corner(cursor, word);
    }
    if (corners < 3) cursor.fail(keyword, "a face of " + std::to_string(corners) + " corners; expected three or more");
    prepared_.bytes += '\n';
    prepared_.triangles += corners - 2;
    if (corners > 3) ++prepared_.notes.polygons;
  }

  /// A corner is `v`, `v/vt`, `v//vn` or `v/vt/vn`.
  void keep_corner(TextCursor& cursor, std::string_view word) {
    ++corners_[0];
    prepared_.bytes += ' ';
    std::string_view rest = word;
    for (std::size_t list = 0; list < 3; ++list) {
      const std::size_t slash = rest.find('/');
      const std::string_view part = rest.substr(0, slash);
      if (part.empty() && (list != 1 || slash == std::string_view::npos)) {
        cursor.fail(part, "the corner " + quoted(word) + " has no " + std::string(kNames[list]) +
                              "; expected v, v/vt, v//vn or v/vt/vn");
      }
      if (!part.empty()) keep_index(resolve(cursor, part, list), list);
      if (slash == std::string_view::npos) return;
      if (list < 2) prepared_.bytes += '/';
      rest.remove_prefix(slash + 1);
    }
    cursor.fail(word, "the corner " + quoted(word) + " has more than three parts; expected v, v/vt, v//vn or v/vt/vn");
  }

  std::uint32_t face() const { return static_cast<std::uint32_t>(prepared_.faces); }

  /// `index` counts from 1.
  void keep_index(long long index, std::size_t list) {
    const auto entry = static_cast<std::size_t>(index - 1);
    if (list > 0) {
      ++corners_[list];
      used_[list][entry] = true;
    } else if (face_of_[entry] == face()) {
      prepared_.stand_ins.push_back(static_cast<std::uint32_t>(entry));
      index = static_cast<long long>(prepared_.vertices + prepared_.stand_ins.size());
    } else {
      face_of_[entry] = face();
    }
    std::array<char, 24> digits;
    prepared_.bytes.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), index).ptr);
  }

  /// The index counted from 1; a negative one in the file counts back from the last entry so far.
  long long resolve(TextCursor& cursor, std::string_view part, std::size_t list) const {
    const auto expected = [&] {
      return "; expected the index of a " + std::string(kNames[list]) + ", of which there are " +
             std::to_string(totals_[list]);
    };
    long long index = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), index);
    if (error == std::errc::invalid_argument || end != part.data() + part.size())
      cursor.fail(part, quoted(part) + " is not a whole number" + expected());
    const long long resolved = index < 0 ? so_far_[list] + 1 + index : index;
    if (error != std::errc() || resolved < 1 || resolved > totals_[list])
      cursor.fail(part, quoted(part) + " is out of range" + expected());
    return resolved;
  }

  void leave_out(std::string_view keyword) {
    constexpr std::size_t kTold = 12;  // of a file that is not OBJ there may be as many as lines
    const std::string name = quoted(keyword);
    if (left_out_.size() < kTold || left_out_.contains(name))
      ++left_out_[name];
    else
      ++left_out_["others"];
  }

  void note() {
    prepared_.notes.format = "OBJ, text";
    auto& sentences = prepared_.notes.sentences;
    std::string statements;
    for (const auto& [name, count] : left_out_)
      statements.append(statements.empty() ? "" : ", ").append(std::to_string(count)).append(" ").append(name);
    if (!statements.empty()) sentences.push_back("statements that are not kept: " + statements);
    if (longer_[0] > 0) sentences.push_back("colours or weights of " + counted_of(longer_[0], 0) + " are not kept");
    if (longer_[1] > 0) sentences.push_back("the third number of " + counted_of(longer_[1], 1) + " is not kept");
    for (std::size_t list = 1; list < 3; ++list) {
      if (corners_[list] > 0 && corners_[list] < corners_[0]) {
        sentences.push_back(std::string(kPlurals[list]) + " are not kept, because only " +
                            std::to_string(corners_[list]) + " of " + std::to_string(corners_[0]) +
                            " corners have one");
      }
      const auto unused = static_cast<std::size_t>(std::count(used_[list].begin(), used_[list].end(), false));
      if (unused > 0) sentences.push_back(counted_of(unused, list) + " of no corner: not kept");
    }
    if (rounded_ > 0) sentences.push_back(rounding_note(rounded_));
  }

  const std::string& content_;
  const std::string& file_;
  std::array<long long, 3> totals_{}, so_far_{};
  /// The number of the last face that has the vertex, counted from 1.
  std::vector<std::uint32_t> face_of_;
  std::array<std::vector<bool>, 3> used_;
  /// How many corners there are, and how many of them have a texture coordinate and a normal.
  std::array<std::size_t, 3> corners_{};
  std::array<std::size_t, 3> longer_{};
  std::map<std::string, std::size_t> left_out_;
  std::size_t rounded_ = 0;
  PreparedMesh prepared_;
};

}  // namespace

PreparedMesh prepare_obj(const std::string& content, const std::string& file) {
  return ObjPreparer(content, file).prepare();
}

}  // namespace plumb
