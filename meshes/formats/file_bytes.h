#pragma once

#include <filesystem>
#include <string>

namespace plumb {

/// The whole content of a regular file. Throws InputError if there is none of that name, it is a folder or
/// a device, or it cannot be read.
std::string file_bytes(const std::filesystem::path& file);

/// The ending with its dot, in lower case (ASCII); empty if the name has none.
std::string lower_case_ending(const std::filesystem::path& file);

}  // namespace plumb
