#include "tools/developer/layers.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <regex>
#include <utility>

namespace plumb {
namespace {

namespace fs = std::filesystem;

/// A room, and the rooms whose headers it may include besides its own. The longest prefix that fits a file is its room.
struct Room {
  std::string_view prefix;
  std::vector<std::string_view> may_include;
};

const std::vector<Room>& rooms() {
  static const std::vector<Room> table{
      {"renderer/math/", {}},
      {"renderer/image/", {"renderer/math/"}},
      {"meshes/", {"renderer/math/"}},
      {"scenes/", {"renderer/math/", "meshes/"}},
      {"reference/", {"renderer/math/", "meshes/", "scenes/"}},
      {"renderer/", {"meshes/", "scenes/"}},
      {"conformance/", {"renderer/", "meshes/", "scenes/", "reference/"}},
      {"reports/", {"conformance/results/", "conformance/verdict.h", "renderer/image/", "renderer/math/"}},
      {"tools/", {"renderer/", "meshes/", "scenes/", "reference/", "conformance/", "reports/"}},
      {"bench/", {"renderer/", "meshes/", "scenes/", "reference/", "conformance/"}},
      {"examples/", {}},
  };
  return table;
}

/// A library, and the only places that may include it.
struct Library {
  std::string_view include_prefix;
  std::vector<std::string_view> users;
};

const std::vector<Library>& libraries() {
  static const std::vector<Library> table{
      {"OpenImageIO/", {"renderer/image/"}},
      {"png.h", {"renderer/image/"}},
      {"OpenMesh/", {"meshes/", "bench/load_bench.cpp"}},
      {"pugixml", {"scenes/"}},
      {"CGAL/", {"reference/", "meshes/validation/self_intersections.cpp", "tools/kernels/cgal.cpp"}},
      {"embree3/", {"tools/kernels/embree.cpp", "bench/peers/embree.cpp"}},
      {"gmp", {"reference/"}},
      {"mpfr", {"reference/", "meshes/generators/correctly_rounded.cpp", "renderer/math/rotation.cpp"}},
      {"toml++/", {"conformance/judge/"}},
      {"openssl/", {"conformance/judge/"}},
      {"CLI/", {"tools/"}},
      {"benchmark/", {"bench/"}},
      {"nlohmann/", {"conformance/", "reports/", "tools/"}},
  };
  return table;
}

const Room* room_of(std::string_view file) {
  const Room* best = nullptr;
  for (const Room& room : rooms())
    if (file.starts_with(room.prefix) && (!best || room.prefix.size() > best->prefix.size())) best = &room;
  return best;
}

bool starts_with_any(std::string_view text, const std::vector<std::string_view>& prefixes) {
  return std::ranges::any_of(prefixes, [&](std::string_view prefix) { return text.starts_with(prefix); });
}

bool is_source(const fs::path& file) { return file.extension() == ".cpp" || file.extension() == ".h"; }

}  // namespace

std::string include_fault(std::string_view file, std::string_view include, bool quoted) {
  if (!quoted) {
    for (const Library& library : libraries())
      if (include.starts_with(library.include_prefix) && !starts_with_any(file, library.users))
        return std::string(file) + " includes <" + std::string(include) + ">, which belongs to another room";
    return "";
  }
  const Room* room = room_of(file);
  if (!room) return std::string(file) + " lies in no room";
  const Room* target = room_of(include);
  // An example stands alone: what it includes by other names lies beside it, where it is built.
  if (!target && room->prefix == "examples/") return "";
  if (!target)
    return std::string(file) + " includes \"" + std::string(include) + "\", which is no path from the project's root";
  if (target == room || starts_with_any(include, room->may_include)) return "";
  // The renderer's own subfolders image and math have rows of their own, which the rest of the renderer may see.
  if (room->prefix == "renderer/" && include.starts_with("renderer/")) return "";
  return std::string(file) + " includes \"" + std::string(include) + "\", which its room may not see";
}

std::string first_include_fault(std::string_view file, std::string_view include) {
  const std::string header = fs::path(file).replace_extension(".h").generic_string();
  if (include == header || file.starts_with("examples/")) return "";
  return std::string(file) + " includes \"" + std::string(include) + "\" before its own header";
}

std::string top_level_fault(std::string_view name) {
  static constexpr std::array<std::string_view, 12> kFolders{"renderer", "reference", "conformance", "meshes",
                                                             "scenes",   "tools",     "reports",     "docs",
                                                             "examples", "bench",     "suites",      "build"};
  static constexpr std::array<std::string_view, 7> kFiles{
      "CMakeLists.txt", "CMakePresets.json", "README.md", "CONTRIBUTING.md", "CHANGELOG.md", "LICENSE", "dev"};
  if (name.starts_with(".") || name.starts_with("plumb-results")) return "";
  if (std::ranges::find(kFolders, name) != kFolders.end() || std::ranges::find(kFiles, name) != kFiles.end()) return "";
  return std::string(name) + " at the top level has no row in the layers table";
}

std::string file_fault(std::string_view file, int lines) {
  constexpr int kLongest = 500;
  static const std::regex vague("(^|[/_])(util|utils|common|helper|helpers|misc)([_.])");
  if (lines > kLongest)
    return std::string(file) + " has " + std::to_string(lines) + " lines, which wants a second room";
  if (std::regex_search(std::string(file), vague)) return std::string(file) + " has a name that says nothing";
  return "";
}

LayersReport check_layers(const fs::path& root) {
  static const std::regex include_line(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
  LayersReport report;
  const auto add = [&](std::string fault) {
    if (!fault.empty()) report.faults.push_back(std::move(fault));
  };
  for (const auto& entry : fs::directory_iterator(root)) add(top_level_fault(entry.path().filename().string()));
  for (const Room& room : rooms()) {
    const std::string_view top = room.prefix.substr(0, room.prefix.find('/'));
    if (room.prefix.size() != top.size() + 1) continue;  // a room within a room is walked with the outer one
    for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
      if (!entry.is_regular_file() || !(is_source(entry.path()) || room.prefix == "examples/")) continue;
      const std::string file = entry.path().lexically_relative(root).generic_string();
      std::ifstream stream(entry.path());
      int lines = 0;
      const bool has_header =
          entry.path().extension() == ".cpp" && fs::exists(fs::path(entry.path()).replace_extension(".h"));
      bool first = true;
      for (std::string line; std::getline(stream, line); ++lines) {
        std::smatch match;
        if (!is_source(entry.path()) || !std::regex_search(line, match, include_line)) continue;
        ++report.includes;
        add(include_fault(file, match[2].str(), match[1] == "\""));
        if (std::exchange(first, false) && has_header) add(first_include_fault(file, match[2].str()));
      }
      add(file_fault(file, lines));
    }
  }
  return report;
}

}  // namespace plumb
