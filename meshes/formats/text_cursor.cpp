#include "meshes/formats/text_cursor.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "meshes/formats/plain_number.h"
#include "meshes/mesh_notes.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

/// std::from_chars takes no '+', and "+-1" must not become -1.
std::string_view without_plus(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-' && word[1] != '+') word.remove_prefix(1);
  return word;
}

/// Why `word` is refused as a number.
std::string fault_of(std::string_view word) {
  const std::string_view digits = without_plus(word);
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (word.empty()) return "nothing stands here";
  if (error == std::errc::invalid_argument || end != digits.data() + digits.size())
    return quoted(word) + " is not a number";
  if (error == std::errc::result_out_of_range) return quoted(word) + " does not fit double precision";
  return quoted(word) + " is not finite";
}

}  // namespace

std::string_view TextCursor::next() {
  while (position_ < text_.size() && is_space(text_[position_])) ++position_;
  const std::size_t begin = position_;
  while (position_ < text_.size() && !is_space(text_[position_])) ++position_;
  return text_.substr(begin, position_ - begin);
}

std::string_view TextCursor::next_in_line(char comment) {
  while (position_ < text_.size() && text_[position_] != '\n' && is_space(text_[position_])) ++position_;
  const std::size_t begin = position_;
  if (begin == text_.size() || (comment != '\0' && text_[begin] == comment)) return text_.substr(begin, 0);
  while (position_ < text_.size() && !is_space(text_[position_]) && (comment == '\0' || text_[position_] != comment)) {
    ++position_;
  }
  return text_.substr(begin, position_ - begin);
}

bool TextCursor::next_line() {
  const std::size_t end = text_.find('\n', position_);
  position_ = end == std::string_view::npos ? text_.size() : end + 1;
  return position_ < text_.size();
}

double TextCursor::number(std::string_view word, std::string_view expected) const {
  double value = 0;
  if (!parse_number(word, value)) fail(word, fault_of(word) + "; expected " + std::string(expected));
  return value;
}

float TextCursor::single(std::string_view word, std::string_view expected) {
  const std::string_view digits = without_plus(word);
  float value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value)) {
    value = static_cast<float>(number(word, expected));  // too small for a float, or wrong
    if (!std::isfinite(value))
      fail(word, quoted(word) + " does not fit single precision; expected " + std::string(expected));
  }
  if (is_rounded(word, value)) ++rounded_;
  return value;
}

std::uint32_t TextCursor::whole(std::string_view word, std::string_view expected) const {
  std::uint32_t value = 0;
  if (!parse_whole(word, value)) {
    const std::string fault =
        word.empty() ? "nothing stands here" : quoted(word) + " is not a whole number from 0 to 4294967295";
    fail(word, fault + "; expected " + std::string(expected));
  }
  return value;
}

void TextCursor::fail(std::string_view word, const std::string& what) const {
  const std::size_t offset = static_cast<std::size_t>(word.data() - text_.data());
  const std::string_view before = text_.substr(0, offset);
  const std::size_t line_start = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
  throw InputError({file_, static_cast<int>(1 + std::count(before.begin(), before.end(), '\n')),
                    static_cast<int>(1 + offset - line_start)},
                   what);
}

void TextCursor::fail_at_end(const std::string& what) const { fail(text_.substr(text_.size()), what); }

std::string quoted(std::string_view word) {
  constexpr std::size_t kLongest = 40;
  std::string text = "'";
  text.append(word.substr(0, kLongest)).append(word.size() > kLongest ? "...'" : "'");
  return text;
}

bool parse_number(std::string_view word, double& value) {
  word = without_plus(word);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size() && std::isfinite(value);
}

bool parse_whole(std::string_view word, std::uint32_t& value) {
  word = without_plus(word);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size();
}

bool is_rounded(std::string_view word, float value) {
  constexpr std::ptrdiff_t kDigits = std::numeric_limits<float>::max_digits10;
  if (word.size() <= kDigits) return false;
  const std::string_view mantissa = word.substr(0, word.find_first_of("eE"));
  const std::size_t first = mantissa.find_first_of("123456789"), last = mantissa.find_last_of("123456789");
  if (first == std::string_view::npos) return false;
  const std::string_view significant = mantissa.substr(first, last - first + 1);
  const std::ptrdiff_t digits = std::ssize(significant) - std::count(significant.begin(), significant.end(), '.');
  double exact = 0;
  return digits > kDigits && parse_number(word, exact) && exact != double{value};
}

std::string rounding_note(std::size_t rounded) {
  return counted(rounded, "number is", "numbers are") + " rounded to single precision, which holds fewer digits";
}

}  // namespace plumb
