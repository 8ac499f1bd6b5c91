#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/film/tiles.h"
#include "scenes/value.h"

namespace plumb {

/// `WxH`. Throws InputError if it is not two whole numbers from 1, or the picture would be absurdly large.
Size2 parse_size(std::string_view text);
/// `X,Y,W,H`. Throws InputError if it is not four whole numbers, or the rectangle is empty.
PixelRect parse_rect(std::string_view text);
/// `count` numbers parted by commas or blanks: decimal, hex floats, `inf`. Throws InputError naming the option.
std::vector<double> parse_numbers(std::string_view option, const std::string& text, std::size_t count);
/// The place of `name` among `names`. Throws InputError naming the option and the nearest known name.
std::size_t parse_choice(std::string_view option, std::string_view name, std::span<const std::string_view> names);

/// A file stands for itself, a folder for every *.xml in it, by name. A folder without one is an InputError.
std::vector<std::filesystem::path> scene_files(const std::vector<std::string>& arguments);

/// The names for --help: `a|b`.
std::string joined(std::span<const std::string_view> names);

}  // namespace plumb
