#include "conformance/subject/probe_numbers.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>

#include "conformance/subject/subject.h"

namespace plumb {

using nlohmann::json;

void append_number(std::string& text, double value) {
  if (!std::isfinite(value)) {
    text += std::isnan(value) ? "\"nan\"" : value > 0 ? "\"inf\"" : "\"-inf\"";
    return;
  }
  std::array<char, 32> digits;
  const std::string_view shortest(digits.data(),
                                  std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
  text += shortest;
  // As an integer, -0 would lose its sign.
  if (shortest.find_first_of(".e") == std::string_view::npos) text += ".0";
}

void append_numbers(std::string& text, std::span<const double> values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) text += ',';
    append_number(text, values[i]);
  }
}

void protocol_fault(const std::string& sentence) { throw SubjectFailure(Verdict::fail, "protocol", sentence); }

double finite_number(const json& value, std::string_view what) {
  if (value.is_string()) {
    const auto& text = value.get_ref<const std::string&>();
    if (text == "inf" || text == "-inf" || text == "nan")
      throw SubjectFailure(Verdict::fail, "not_finite", fmt::format("{} is {}", what, text));
  }
  if (!value.is_number()) protocol_fault(fmt::format("{} is not a number", what));
  return value.get<double>();
}

const json& list_of(const json& value, std::string_view what) {
  if (!value.is_array()) protocol_fault(fmt::format("{} is not a list", what));
  return value;
}

const json& list_of(const json& value, std::size_t count, std::string_view what) {
  if (list_of(value, what).size() != count)
    protocol_fault(fmt::format("{} is a list of {}, expected {}", what, value.size(), count));
  return value;
}

std::vector<double> finite_numbers(const json& value, std::size_t count, std::string_view what) {
  std::vector<double> values;
  values.reserve(count);
  for (const auto& item : list_of(value, count, what)) values.push_back(finite_number(item, what));
  return values;
}

std::size_t index_below(const json& value, std::size_t end, std::string_view what) {
  if (!value.is_number_integer()) protocol_fault(fmt::format("{} is not a whole number", what));
  const auto index = value.get<std::int64_t>();
  if (index < 0 || static_cast<std::uint64_t>(index) >= end)
    protocol_fault(fmt::format("{} is {}, expected less than {}", what, shown(value), end));
  return static_cast<std::size_t>(index);
}

const json& member(const json& value, const char* key, std::string_view what) {
  if (!value.is_object()) protocol_fault(fmt::format("{} is not an object", what));
  const auto found = value.find(key);
  if (found == value.end()) protocol_fault(fmt::format("{} has no \"{}\"", what, key));
  return *found;
}

std::string shown(const json& value) {
  constexpr std::size_t kLongest = 40;
  const std::string text = value.dump(-1, ' ', true);  // ASCII, so that it can be cut anywhere
  return text.size() > kLongest ? text.substr(0, kLongest) + "..." : text;
}

std::string sentence_of(const json& value, std::string_view what) {
  constexpr std::size_t kLongest = 500;
  if (!value.is_string()) protocol_fault(fmt::format("{} is not text", what));
  std::string text = value.get<std::string>();
  const auto is_continuation = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; };
  if (text.size() > kLongest) {
    std::size_t end = kLongest;
    while (end > 0 && is_continuation(text[end])) --end;
    text = text.substr(0, end) + " ...";
  }
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
  return text;
}

}  // namespace plumb
