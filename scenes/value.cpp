#include "scenes/value.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <vector>

namespace plumb {
namespace {

constexpr std::string_view kWhiteSpace = " \t\r\n\f\v";

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t at = text.find_first_not_of(kWhiteSpace); at != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(kWhiteSpace, at), text.size());
    words.push_back(text.substr(at, end - at));
    at = text.find_first_not_of(kWhiteSpace, end);
  }
  return words;
}

class ValueReader {
 public:
  ValueReader(const Parameter& parameter, std::string_view text, const SourceLocation& where)
      : parameter_(parameter), words_(words_of(text)), where_(where) {}

  void expect_count(std::size_t count) const {
    if (words_.size() == count) return;
    const std::string found = words_.empty() ? "nothing" : std::to_string(words_.size()) + (words_.size() == 1 ? " value" : " values");
    fail("found " + found);
  }

  double number(std::size_t i) const {
    double value = parsed<double>(i);
    if (!std::isfinite(value)) fail("'" + std::string(words_[i]) + "' is not a finite number");
    check_range(value);
    return value;
  }

  int integer(std::size_t i) const {
    const int value = parsed<int>(i);
    check_range(value);
    return value;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(where_, "<" + std::string(parameter_.name) + ">: " + what + ", expected " +
                                 std::string(to_string(parameter_.type)));
  }

  template <class Number>
  Number parsed(std::size_t i) const {
    std::string_view word = words_[i];
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);  // from_chars takes no plus sign
    Number value{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    // A number too large for the type says so; one too close to zero for a double is an error as well.
    if (error == std::errc::result_out_of_range) fail("'" + std::string(words_[i]) + "' is out of range");
    if (error != std::errc{} || end != word.data() + word.size()) fail("'" + std::string(words_[i]) + "' is no such number");
    return value;
  }

  void check_range(double value) const {
    if (parameter_.range == Range::not_negative && value < 0)
      throw InputError(where_, "<" + std::string(parameter_.name) + "> must not be negative, but it is " + std::string(words_[0]));
    if (parameter_.range == Range::positive && !(value > 0))
      throw InputError(where_, "<" + std::string(parameter_.name) + "> must be greater than zero, but it is " + std::string(words_[0]));
  }

  const Parameter& parameter_;
  std::vector<std::string_view> words_;
  const SourceLocation& where_;
};

std::string file_name(const Parameter& parameter, std::string_view text, const SourceLocation& where) {
  const std::size_t first = text.find_first_not_of(kWhiteSpace);
  if (first == std::string_view::npos) {
    throw InputError(where, "<" + std::string(parameter.name) + "> is empty, expected a file name");
  }
  return std::string(text.substr(first, text.find_last_not_of(kWhiteSpace) - first + 1));
}

}  // namespace

Value parse_value(const Parameter& parameter, std::string_view text, const SourceLocation& where) {
  if (parameter.type == ValueType::file) return file_name(parameter, text, where);
  const ValueReader reader(parameter, text, where);
  switch (parameter.type) {
    case ValueType::number:
      reader.expect_count(1);
      return reader.number(0);
    case ValueType::integer:
      reader.expect_count(1);
      return reader.integer(0);
    case ValueType::size:
      reader.expect_count(2);
      return Size2{reader.integer(0), reader.integer(1)};
    case ValueType::point:
    case ValueType::vector:
    case ValueType::color:
      reader.expect_count(3);
      return Vec3{reader.number(0), reader.number(1), reader.number(2)};
    case ValueType::file:
    case ValueType::object: break;
  }
  throw std::logic_error("this parameter is not a value");
}

}  // namespace plumb
