#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "conformance/judge/suite.h"

namespace plumb {

/// Where a case's scene and picture lie, relative to the folder that the program runs in.
struct CasePaths {
  std::string scene;
  std::string scene_name;
  std::string folder;
  std::string output;
  /// Of the picture that is asked for; 0: not known.
  int width = 0, height = 0;
};

CasePaths case_paths(const Runner& runner, const SuiteCase& suite_case);

/// The render command with its placeholders filled in.
std::vector<std::string> render_command(const Runner& runner, const CasePaths& paths);

/// A build command with each {sources:GLOB} replaced by the files below `folder` that match, sorted by name. In a GLOB,
/// `*` and `?` match within a name and `**` any number of folders. A name that begins with '-' or '@', which compilers
/// take for options and lists of files, gets "./" before it. Hidden files and
/// what lies in hidden folders (`.svn`, `._x.java`) never match. Throws InputError if nothing matches.
std::vector<std::string> build_command(const std::vector<std::string>& command, const std::filesystem::path& folder);

/// Whether the name begins with a dot.
bool is_hidden(const std::filesystem::path& file);

/// Whether a relative path matches a GLOB as above.
bool glob_matches(const std::filesystem::path& glob, const std::filesystem::path& path);

}  // namespace plumb
