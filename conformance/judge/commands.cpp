#include "conformance/judge/commands.h"

#include <fnmatch.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "renderer/math/input_error.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;
constexpr std::string_view kSources = "{sources:";

void replace_all(std::string& text, std::string_view name, std::string_view value) {
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + value.size()))
    text.replace(at, name.size(), value);
}

std::string filled(std::string text, const CasePaths& paths) {
  replace_all(text, "{scene}", paths.scene);
  replace_all(text, "{scene_name}", paths.scene_name);
  replace_all(text, "{folder}", paths.folder);
  replace_all(text, "{output}", paths.output);
  replace_all(text, "{width}", std::to_string(paths.width));
  replace_all(text, "{height}", std::to_string(paths.height));
  return text;
}

/// By a table over (part of the glob, part of the path), so that many `**` cost no more than their product.
bool parts_match(const std::vector<fs::path>& glob, const std::vector<fs::path>& path) {
  // reached[j]: whether the parts of the glob so far match the first j parts of the path.
  std::vector<bool> reached(path.size() + 1, false);
  reached[0] = true;
  for (const fs::path& part : glob) {
    std::vector<bool> next(path.size() + 1, false);
    for (std::size_t j = 0; j <= path.size(); ++j) {
      if (part == "**")
        next[j] = reached[j] || (j > 0 && next[j - 1]);
      else if (j > 0)
        next[j] = reached[j - 1] && ::fnmatch(part.c_str(), path[j - 1].c_str(), 0) == 0;
    }
    reached = std::move(next);
  }
  return reached.back();
}

std::vector<std::string> matching_files(const std::string& glob, const fs::path& folder) {
  std::vector<std::string> files;
  for (auto it = fs::recursive_directory_iterator(folder); it != fs::recursive_directory_iterator(); ++it) {
    const fs::directory_entry& entry = *it;
    if (is_hidden(entry.path())) {
      if (entry.is_directory()) it.disable_recursion_pending();
      continue;
    }
    const fs::path relative = entry.path().lexically_relative(folder);
    if (!entry.is_regular_file() || !glob_matches(glob, relative)) continue;
    const std::string name = relative.generic_string();
    files.push_back(name.starts_with('-') || name.starts_with('@') ? "./" + name : name);
  }
  if (files.empty()) throw InputError({}, "no file of the submission matches '" + glob + "'");
  std::ranges::sort(files);
  return files;
}

}  // namespace

bool is_hidden(const fs::path& file) { return file.filename().string().starts_with('.'); }

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
      const std::vector<std::string> files =
          matching_files(argument.substr(kSources.size(), argument.size() - kSources.size() - 1), folder);
      result.insert(result.end(), files.begin(), files.end());
    } else {
      result.push_back(argument);
    }
  }
  return result;
}

bool glob_matches(const fs::path& glob, const fs::path& path) {
  return parts_match({glob.begin(), glob.end()}, {path.begin(), path.end()});
}

}  // namespace plumb
