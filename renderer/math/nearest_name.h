#pragma once

#include <span>
#include <string>
#include <string_view>

namespace plumb {

/// The candidate with the fewest single-letter edits to `word`, regardless of case (Levenshtein distance);
/// the first of equals. Empty if none is within a third of the word's length, at least 2.
std::string_view nearest_name(std::string_view word, std::span<const std::string_view> candidates);

/// `; did you mean <X>?` for the nearest candidate, or nothing: the end of an error message.
std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates);

/// Whether two names are equal but for the case of their ASCII letters.
bool equal_ignoring_case(std::string_view a, std::string_view b);

}  // namespace plumb
