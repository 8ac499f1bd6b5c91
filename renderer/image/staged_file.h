#pragma once

#include <filesystem>
#include <span>
#include <string_view>

namespace plumb {

/// Writes a file so that it is there whole or not at all: to `FILE.partial` beside it, then renamed. An
/// older file of that name stays untouched until then. Throws InputError naming the file and the reason.
void write_file_staged(const std::filesystem::path& file, std::string_view bytes);

/// Throws the InputError that writing the file would end in, where that can be known beforehand: its
/// folder does not exist or cannot be written, or it is a folder itself. Asked before long work.
void require_writable(const std::filesystem::path& file);

}  // namespace plumb
