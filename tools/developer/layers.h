#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace plumb {

/// What may include what: docs/architecture.md, as a table. Paths are relative to the project's root.

/// What is wrong with one include of one file, in a sentence; empty if it is allowed. `include` is the text between the
/// quotes or angle brackets, `quoted` whether it stood in quotes.
std::string include_fault(std::string_view file, std::string_view include, bool quoted);

/// What is wrong with the first include of a source whose header, of the same name, lies beside it: it has to be that
/// header, which is so compiled alone. Empty if it is right.
std::string first_include_fault(std::string_view file, std::string_view include);

/// What is wrong with an entry of the project's top level; empty if it has its row.
std::string top_level_fault(std::string_view name);

/// What is wrong with a source file as such: its name, or its length in lines.
std::string file_fault(std::string_view file, int lines);

/// The faults of a whole source tree, and how many includes were looked at.
struct LayersReport {
  std::vector<std::string> faults;
  int includes = 0;
};
LayersReport check_layers(const std::filesystem::path& root);

}  // namespace plumb
