#include "tools/plumb/ready_suite.h"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>

#include "conformance/judge/build_suite.h"
#include "conformance/judge/suite_hash.h"
#include "renderer/math/input_error.h"
#include "tools/plumb/progress_bar.h"
#include "tools/plumb/shipped.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

fs::path cache_folder() {
  if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache && *cache) return fs::path(cache) / "plumb";
  if (const char* home = std::getenv("HOME"); home && *home) return fs::path(home) / ".cache/plumb";
  throw InputError({},
                   "neither XDG_CACHE_HOME nor HOME says where to keep a built suite: build it (plumb suite build)");
}

}  // namespace

Suite ready_suite(const fs::path& path) {
  Suite suite = read_suite(fs::is_directory(path) ? path / "suite.toml" : path);
  if (!suite.needs_build()) return suite;
  const bool has_mutants = has_shipped_mutants();
  const fs::path built =
      cache_folder() / fmt::format("{}-{}-{}{}", suite.id, suite.hash.substr(0, 16),
                                   file_hash("/proc/self/exe").substr(0, 16), has_mutants ? "-mistakes" : "");
  if (!fs::is_regular_file(built / "suite.toml")) {
    fmt::print(stderr, "building the suite into {} (once) ...\n", built.string());
    fs::create_directories(built.parent_path());
    ProgressBar bar(suite.id);
    SuiteBuildRequest request;
    request.suite = suite.file;
    request.out = built;
    request.plumb_version = PLUMB_VERSION;
    if (has_mutants) request.mutants = shipped_mutants(), request.known_mistakes = shipped_known_mistakes();
    request.progress = [&](const std::string&, double share) { bar.show(share); };
    build_suite(request);
  }
  return read_suite(built / "suite.toml");
}

}  // namespace plumb
