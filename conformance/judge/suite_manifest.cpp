#include "conformance/judge/suite_manifest.h"

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "conformance/judge/build_suite.h"
#include "conformance/judge/suite_hash.h"
#include "renderer/image/staged_file.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kManifest = "manifest.json";

/// By path from the folder, with '/'.
std::map<std::string, std::string> hashes_of(const fs::path& folder) {
  std::map<std::string, std::string> hashes;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().lexically_relative(folder).generic_string();
    if (entry.is_regular_file() && name != kManifest) hashes[name] = file_hash(entry.path());
  }
  return hashes;
}

}  // namespace

void write_manifest(const fs::path& folder, const ManifestFacts& facts) {
  Json json;
  json["schema"] = 1;
  json["suite"] = facts.suite;
  json["plumb"] = facts.version;
  json["seed"] = facts.seed ? Json(*facts.seed) : Json();
  json["files"] = Json::object();
  for (const auto& [name, hash] : hashes_of(folder)) json["files"][name] = hash;
  write_file_staged(folder / kManifest, json.dump(2) + "\n");
}

void require_replaceable_suite(const fs::path& folder) {
  if (!fs::exists(fs::symlink_status(folder))) return;
  const bool is_folder = fs::is_directory(fs::symlink_status(folder));
  if (is_folder && (fs::is_empty(folder) || fs::is_regular_file(folder / kManifest))) return;
  throw InputError({folder.string()},
                   "holds something that is no built suite and would be lost, expected a new folder or an earlier one");
}

std::vector<std::string> verify_suite(const fs::path& built) {
  const fs::path file = built / kManifest;
  std::ifstream stream(file);
  const Json json = Json::parse(stream, nullptr, false);
  if (!json.is_object() || !json.contains("files") || !json["files"].is_object())
    throw InputError({file.string()}, "is no manifest of a built suite, expected what 'plumb suite build' writes");
  std::vector<std::string> faults;
  std::map<std::string, std::string> found = hashes_of(built);
  for (const auto& [name, hash] : json["files"].items()) {
    const auto here = found.find(name);
    if (here == found.end())
      faults.push_back(name + ": is missing");
    else if (here->second != hash.get<std::string>())
      faults.push_back(name + ": was changed");
    if (here != found.end()) found.erase(here);
  }
  for (const auto& [name, hash] : found) faults.push_back(name + ": was added");
  return faults;
}

}  // namespace plumb
