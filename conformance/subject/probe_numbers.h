#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/math/vec3.h"

namespace plumb {

/// Appends a JSON number that reads back to the same bits, also where a reader takes numbers without a point for
/// integers: the shortest decimals, at least one after the point or an exponent. "inf", "-inf" and "nan" as strings.
void append_number(std::string& text, double value);
/// Appends the numbers, with commas between.
void append_numbers(std::string& text, std::span<const double> values);
/// The same for the three numbers of a triple.
template <class Triple>
void append_triple(std::string& text, const Triple& v) {
  const double values[]{v.x, v.y, v.z};
  append_numbers(text, values);
}

/// Parts of an answer, checked. `what` names the part: `t of a hit`. All throw SubjectFailure: fail with `protocol` for
/// what is missing or of another type or length, with `not_finite` for NaN and the infinities.
[[noreturn]] void protocol_fault(const std::string& sentence);
double finite_number(const nlohmann::json& value, std::string_view what);
/// A list; of `count` items where that is given.
const nlohmann::json& list_of(const nlohmann::json& value, std::string_view what);
const nlohmann::json& list_of(const nlohmann::json& value, std::size_t count, std::string_view what);
std::vector<double> finite_numbers(const nlohmann::json& value, std::size_t count, std::string_view what);
template <class Triple>
Triple finite_triple(const nlohmann::json& value, std::string_view what) {
  const std::vector<double> v = finite_numbers(value, 3, what);
  return {v[0], v[1], v[2]};
}
/// A whole number in [0, end).
std::size_t index_below(const nlohmann::json& value, std::size_t end, std::string_view what);
const nlohmann::json& member(const nlohmann::json& value, const char* key, std::string_view what);
/// The beginning of the value as JSON, for messages.
std::string shown(const nlohmann::json& value);
/// Text for people: without control characters, not longer than a paragraph.
std::string sentence_of(const nlohmann::json& value, std::string_view what);

}  // namespace plumb
