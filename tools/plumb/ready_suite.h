#pragma once

#include <filesystem>

#include "conformance/judge/suite.h"

namespace plumb {

/// The suite to grade by: a file, or the folder that `plumb suite build` made. One that still needs to be built is
/// built into the user's cache ($XDG_CACHE_HOME/plumb, or ~/.cache/plumb), once for each content of its files and
/// version of this program; with the pictures of known mistakes where their programs are there. Throws as read_suite
/// and build_suite.
Suite ready_suite(const std::filesystem::path& suite);

}  // namespace plumb
