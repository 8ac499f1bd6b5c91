#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace plumb {

/// What stands in the manifest of a built suite beside the hashes of its files.
struct ManifestFacts {
  std::string suite;
  /// Of the program that built it.
  std::string version;
  /// Of the cameras of further views; nothing where there are none.
  std::optional<std::uint64_t> seed;
};

/// Writes `manifest.json` into the folder: the facts, and the SHA-256 of every file in it by its path, sorted.
void write_manifest(const std::filesystem::path& folder, const ManifestFacts& facts);

/// Throws InputError if the folder holds something that is no built suite.
void require_replaceable_suite(const std::filesystem::path& folder);

}  // namespace plumb
