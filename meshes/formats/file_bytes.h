#pragma once

#include <filesystem>
#include <string>

namespace plumb {

/// Throws InputError if there is no file of that name, or it is a folder, a pipe or a device.
void require_regular_file(const std::filesystem::path& file);

/// The whole content of a regular file. Throws InputError as require_regular_file does, and if it
/// cannot be read.
std::string file_bytes(const std::filesystem::path& file);

/// The ending with its dot, in lower case (ASCII); empty if the name has none.
std::string lower_case_ending(const std::filesystem::path& file);

}  // namespace plumb
