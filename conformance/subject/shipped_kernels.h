#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plumb {

/// The folder of the kernels that come with us: `../lib/plumb/kernels` seen from the program that runs.
std::filesystem::path shipped_kernels_folder();

/// Their names, sorted; empty if the folder is not there.
std::vector<std::string> shipped_kernel_names();

/// The library of the shipped kernel with this name. Throws InputError, with the name that may have been meant.
std::filesystem::path shipped_kernel(std::string_view name);

}  // namespace plumb
