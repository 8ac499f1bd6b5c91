#include "conformance/judge/commands.h"

#include <fnmatch.h>

#include <algorithm>
#include <string_view>

#include "renderer/math/input_error.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;
constexpr std::string_view kSources = "{sources:";

void replace_all(std::string& text, std::string_view name, std::string_view value) {
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + value.size())) text.replace(at, name.size(), value);
}

std::string filled(std::string text, const CasePaths& paths) {
  replace_all(text, "{scene}", paths.scene);
  replace_all(text, "{scene_name}", paths.scene_name);
  replace_all(text, "{folder}", paths.folder);
  replace_all(text, "{output}", paths.output);
  return text;
}

bool parts_match(std::vector<fs::path>::const_iterator glob, std::vector<fs::path>::const_iterator glob_end,
                 std::vector<fs::path>::const_iterator path, std::vector<fs::path>::const_iterator path_end) {
  if (glob == glob_end) return path == path_end;
  if (*glob == "**") {
    for (auto rest = path;; ++rest) {
      if (parts_match(glob + 1, glob_end, rest, path_end)) return true;
      if (rest == path_end) return false;
    }
  }
  return path != path_end && ::fnmatch(glob->c_str(), path->c_str(), 0) == 0 && parts_match(glob + 1, glob_end, path + 1, path_end);
}

std::vector<std::string> matching_files(const std::string& glob, const fs::path& folder) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const fs::path relative = entry.path().lexically_relative(folder);
    if (!entry.is_regular_file() || !glob_matches(glob, relative)) continue;
    const std::string name = relative.generic_string();
    files.push_back(name.starts_with('-') ? "./" + name : name);
  }
  if (files.empty()) throw InputError({}, "no file of the submission matches '" + glob + "'");
  std::ranges::sort(files);
  return files;
}

}  // namespace

CasePaths case_paths(const Runner& runner, const SuiteCase& suite_case) {
  CasePaths paths;
  const fs::path folder = fs::path(runner.scene_at).lexically_normal();
  paths.scene_name = suite_case.scene.filename().string();
  paths.scene = (folder / paths.scene_name).lexically_normal().generic_string();
  const std::string parent = fs::path(paths.scene).parent_path().generic_string();
  paths.folder = parent.empty() ? "." : parent;
  paths.output = fs::path(filled(runner.output, paths)).lexically_normal().generic_string();
  return paths;
}

std::vector<std::string> render_command(const Runner& runner, const CasePaths& paths) {
  std::vector<std::string> command;
  for (const std::string& argument : runner.render) command.push_back(filled(argument, paths));
  return command;
}

std::vector<std::string> build_command(const std::vector<std::string>& command, const fs::path& folder) {
  std::vector<std::string> result;
  for (const std::string& argument : command) {
    if (argument.starts_with(kSources)) {
      const std::vector<std::string> files = matching_files(argument.substr(kSources.size(), argument.size() - kSources.size() - 1), folder);
      result.insert(result.end(), files.begin(), files.end());
    } else {
      result.push_back(argument);
    }
  }
  return result;
}

bool glob_matches(const fs::path& glob, const fs::path& path) {
  const std::vector<fs::path> glob_parts(glob.begin(), glob.end());
  const std::vector<fs::path> path_parts(path.begin(), path.end());
  return parts_match(glob_parts.begin(), glob_parts.end(), path_parts.begin(), path_parts.end());
}

}  // namespace plumb
