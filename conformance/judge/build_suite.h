#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace plumb {

struct SuiteBuildRequest {
  /// The suite to build.
  std::filesystem::path suite;
  /// The folder to make; must not exist, be empty, or be a suite that was built.
  std::filesystem::path out;
  /// How many views more of each scene, and the seed of their cameras.
  int jitters = 0;
  std::uint64_t seed = 0;
  /// Known-correct pictures, `CASE/*.png` below it, in place of scenes that we can read; empty: by the scenes.
  std::filesystem::path pictures;
  /// The programs with known mistakes (`./dev mutants`), and the texts that go with them; empty: no fingerprints.
  std::filesystem::path mutants;
  std::filesystem::path known_mistakes;
  std::string plumb_version;
  /// Told what is being done, and the share of all of it that is done.
  std::function<void(const std::string&, double)> progress = [](const std::string&, double) {};
};

/// What became of one case.
struct BuiltCase {
  std::string id;
  double undecidable_share = 0;
  /// Made from pictures alone.
  bool guessed = false;
};

struct BuiltSuite {
  std::vector<BuiltCase> cases;
  int fingerprints = 0;
};

/// Makes a suite that can be graded by and moved about: a folder with everything that the suite names, an envelope for
/// each case of kind image that has no reference and each variant, `jitters` more views of each such scene, which share
/// its points, the pictures of known mistakes, and `manifest.json` with the SHA-256 of every file. The same suite, seed
/// and programs give the same bytes.
///
/// Throws InputError for a suite or scene that cannot be read, a scene of which more than the suite's
/// `undecidable_limit` cannot be decided, and a folder that would be lost; std::runtime_error where it is interrupted
/// (interrupt_flag), with nothing left behind.
BuiltSuite build_suite(const SuiteBuildRequest& request);

/// What is wrong with a built suite, one line each: files that are missing, changed, or not in its manifest. Throws
/// InputError if there is no manifest that can be read.
std::vector<std::string> verify_suite(const std::filesystem::path& built);

}  // namespace plumb
