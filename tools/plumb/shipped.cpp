#include "tools/plumb/shipped.h"

namespace plumb {
namespace {

std::filesystem::path prefix() { return std::filesystem::read_symlink("/proc/self/exe").parent_path().parent_path(); }

}  // namespace

std::filesystem::path shipped_folder() { return prefix() / "share/plumb"; }
std::filesystem::path shipped_mutants() { return prefix() / "mutants"; }
std::filesystem::path shipped_known_mistakes() { return shipped_folder() / "known-mistakes"; }

bool has_shipped_mutants() {
  for (const auto& text : std::filesystem::directory_iterator(shipped_known_mistakes()))
    if (!std::filesystem::is_regular_file(shipped_mutants() / text.path().stem())) return false;
  return true;
}

}  // namespace plumb
