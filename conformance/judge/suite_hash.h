#pragma once

#include <filesystem>
#include <string>

#include "conformance/judge/suite.h"

namespace plumb {

/// SHA-256, in hexadecimal. Throws InputError if the file cannot be read.
std::string file_hash(const std::filesystem::path& file);

/// Over the suite's file and the name and content of every file that it names, in its order.
std::string suite_hash(const Suite& suite);

}  // namespace plumb
