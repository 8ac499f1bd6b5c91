#include "scenes/value.h"

#include <array>
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
    const std::string found =
        words_.empty() ? "nothing" : std::to_string(words_.size()) + (words_.size() == 1 ? " value" : " values");
    fail("found " + found);
  }

  double number(std::size_t i) const {
    const double value = parsed<double>(i);
    if (!std::isfinite(value)) fail("'" + std::string(words_[i]) + "' is not a finite number");
    return value;
  }

  int integer(std::size_t i) const { return parsed<int>(i); }

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
    if (error != std::errc{} || end != word.data() + word.size())
      fail("'" + std::string(words_[i]) + "' is no such number");
    return value;
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

std::string short_text(double value) {
  std::array<char, 32> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

void check_number(const Parameter& parameter, double value, const SourceLocation& where) {
  const auto fail = [&](const std::string& rule) {
    throw InputError(where, "<" + std::string(parameter.name) + "> must " + rule + ", but it is " + short_text(value));
  };
  if (parameter.range == Range::not_negative && value < 0) fail("not be negative");
  if (parameter.range == Range::positive && !(value > 0)) fail("be greater than zero");
  if (value > parameter.largest) fail("be at most " + short_text(parameter.largest));
}

Value parse_text(const Parameter& parameter, std::string_view text, const SourceLocation& where) {
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
    case ValueType::object:
      break;
  }
  throw std::logic_error("this parameter is not a value");
}

}  // namespace

Value parse_value(const Parameter& parameter, std::string_view text, const SourceLocation& where) {
  Value value = parse_text(parameter, text, where);
  check_range(parameter, value, where);
  return value;
}

void check_range(const Parameter& parameter, const Value& value, const SourceLocation& where) {
  const auto check = [&](double number) { check_number(parameter, number, where); };
  if (const auto* number = std::get_if<double>(&value)) check(*number);
  if (const auto* number = std::get_if<int>(&value)) check(*number);
  if (const auto* size = std::get_if<Size2>(&value)) {
    check(size->width);
    check(size->height);
  }
  if (const auto* triple = std::get_if<Vec3>(&value))
    for (int axis = 0; axis < 3; ++axis) check((*triple)[axis]);
}

}  // namespace plumb
