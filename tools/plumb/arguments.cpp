#include "tools/plumb/arguments.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <optional>

#include "renderer/math/input_error.h"
#include "renderer/math/nearest_name.h"
#include "scenes/scene_kind.h"

namespace plumb {
namespace {

/// Whole numbers with this letter between them, or nothing.
std::optional<std::vector<int>> whole_numbers(std::string_view text, char separator) {
  std::vector<int> numbers;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (true) {
    int number = 0;
    const auto [next, error] = std::from_chars(at, end, number);
    if (error != std::errc{}) return std::nullopt;
    numbers.push_back(number);
    if (next == end) return numbers;
    if (*next != separator) return std::nullopt;
    at = next + 1;
  }
}

}  // namespace

Size2 parse_size(std::string_view text) {
  const auto numbers = whole_numbers(text, 'x');
  if (!numbers || numbers->size() != 2 || (*numbers)[0] < 1 || (*numbers)[1] < 1) {
    throw InputError({}, "--size: '" + std::string(text) + "' is no size, expected WxH such as 640x480");
  }
  const Size2 size{(*numbers)[0], (*numbers)[1]};
  if (size.width > kLargestImageSide || size.height > kLargestImageSide ||
      static_cast<long>(size.width) * size.height > kMostImagePixels) {
    throw InputError({}, "--size: '" + std::string(text) + "' is too large, expected at most " +
                             std::to_string(kLargestImageSide) + " a side and " + std::to_string(kMostImagePixels) +
                             " pixels");
  }
  return size;
}

PixelRect parse_rect(std::string_view text) {
  const auto numbers = whole_numbers(text, ',');
  if (!numbers || numbers->size() != 4 || (*numbers)[0] < 0 || (*numbers)[1] < 0 || (*numbers)[2] < 1 ||
      (*numbers)[3] < 1) {
    throw InputError(
        {}, "--crop: '" + std::string(text) + "' is no part of a picture, expected X,Y,W,H with rows from the top");
  }
  return {(*numbers)[0], (*numbers)[1], (*numbers)[2], (*numbers)[3]};
}

std::vector<double> parse_numbers(std::string_view option, const std::string& text, std::size_t count) {
  std::vector<double> numbers;
  const char* at = text.c_str();
  while (*at != '\0') {
    char* end = nullptr;
    const double number = std::strtod(at, &end);
    if (end == at) break;
    numbers.push_back(number);
    at = end + std::strspn(end, " \t\n");
    if (*at == ',') ++at;
  }
  if (*at != '\0' || numbers.size() != count)
    throw InputError(
        {}, std::string(option) + ": '" + text + "', expected " + std::to_string(count) + " numbers parted by commas");
  return numbers;
}

std::size_t parse_choice(std::string_view option, std::string_view name, std::span<const std::string_view> names) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    throw InputError({}, std::string(option) + ": unknown value '" + std::string(name) + "', expected " +
                             joined(names) + did_you_mean(name, names));
  }
  return static_cast<std::size_t>(found - names.begin());
}

std::vector<std::filesystem::path> scene_files(const std::vector<std::string>& arguments) {
  namespace fs = std::filesystem;
  std::vector<fs::path> files;
  for (const std::string& argument : arguments) {
    std::error_code error;
    if (!fs::is_directory(argument, error)) {
      files.emplace_back(argument);
      continue;
    }
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(argument, error))
      if (equal_ignoring_case(entry.path().extension().string(), ".xml")) found.push_back(entry.path());
    if (error) throw InputError({argument}, "cannot read the folder: " + error.message());
    if (found.empty()) throw InputError({argument}, "the folder holds no scene, expected files that end in .xml");
    std::sort(found.begin(), found.end());
    files.insert(files.end(), found.begin(), found.end());
  }
  return files;
}

std::string joined(std::span<const std::string_view> names) {
  std::string text;
  for (const std::string_view name : names) text += (text.empty() ? "" : "|") + std::string(name);
  return text;
}

}  // namespace plumb
