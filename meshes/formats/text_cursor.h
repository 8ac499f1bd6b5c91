#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace plumb {

/// Walks through the words of a text file: runs of bytes without white space (space, tab, CR, LF, VT, FF).
/// The words are views into the text, which must outlive the cursor. Line and column are worked out from
/// a word's address only when an error is raised.
class TextCursor {
 public:
  TextCursor(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {}

  /// The next word; at the end of the text an empty view that still tells the place.
  std::string_view next();
  /// The next word of the line; at the line's end an empty view that tells the place. The words from
  /// `comment` (unless it is NUL) to the line's end do not count.
  std::string_view next_in_line(char comment = '\0');
  /// Steps behind the end of the current line. False if the text has no further line.
  bool next_line();
  /// The bytes behind the last word that was taken.
  std::size_t bytes_left() const { return text_.size() - position_; }
  /// The offset behind the last word or line that was taken.
  std::size_t position() const { return position_; }
  /// The text from there on, for a reader that knows its numbers better; `take` tells the cursor how far that came.
  std::string_view rest() const { return text_.substr(position_); }
  void take(std::size_t bytes) { position_ += bytes; }

  /// The finite number that `word` spells in decimal, with or without a sign. Otherwise throws InputError
  /// at the word: what is wrong with it, and that `expected` was expected.
  double number(std::string_view word, std::string_view expected) const;
  /// As `number`, rounded to single precision; also refuses what does not fit that.
  float single(std::string_view word, std::string_view expected);
  /// How many of the numbers that `single` gave have more digits than single precision holds (see is_rounded).
  std::size_t rounded() const { return rounded_; }
  /// The whole number from 0 to 4294967295 that `word` spells; otherwise InputError as `number`.
  std::uint32_t whole(std::string_view word, std::string_view expected) const;

  /// Throws InputError at a word of this text.
  [[noreturn]] void fail(std::string_view word, const std::string& what) const;
  /// Throws InputError at the end of the text.
  [[noreturn]] void fail_at_end(const std::string& what) const;

 private:
  std::string_view text_;
  std::string file_;
  std::size_t position_ = 0, rounded_ = 0;
};

/// `word` between quotes, cut after 40 bytes.
std::string quoted(std::string_view word);

/// Whether `word` spells a finite number that fits a double, and if so which. Decimal, with or without a sign.
bool parse_number(std::string_view word, double& value);
/// The same for a whole number from 0 to 4294967295.
bool parse_whole(std::string_view word, std::uint32_t& value);

/// Whether the number that `word` spells says more than the float nearest to it: it has more than nine significant
/// digits, which tell any two floats apart, and is not that float.
bool is_rounded(std::string_view word, float value);
/// What to note of numbers that were rounded so; there must be some.
std::string rounding_note(std::size_t rounded);

}  // namespace plumb
