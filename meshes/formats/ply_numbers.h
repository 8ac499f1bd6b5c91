#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "meshes/formats/ply_header.h"
#include "meshes/formats/text_cursor.h"

namespace plumb {

/// Takes number after number from the body of a PLY file, text or binary. The content must outlive it.
class PlyNumbers {
 public:
  PlyNumbers(std::string_view content, std::string file, const TextCursor& at_body, PlyFormat format);

  /// The next number; text ignores the type. Not finite only where a binary file says so. Throws InputError
  /// at the end of the file and for a word that is no finite number.
  double next(PlyType type) { return last_ = take(type); }
  /// Whether the number taken last says more than the float nearest to it: of a text as is_rounded tells.
  bool is_rounded_to(float value) const;
  /// Of a binary file: where the next number begins, and to pass over some bytes, which must be there.
  std::size_t offset() const { return offset_; }
  void pass(std::size_t bytes) { offset_ += bytes; }
  /// Throws InputError unless all numbers have been taken.
  void expect_end();
  /// Throws InputError, in a text at the number taken last.
  [[noreturn]] void fail(const std::string& what) const;

 private:
  double take(PlyType type);

  std::string_view content_;
  std::string file_;
  TextCursor text_;
  std::string_view word_;
  PlyFormat format_;
  std::size_t offset_;
  double last_ = 0;
};

}  // namespace plumb
