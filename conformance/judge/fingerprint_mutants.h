#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>

#include "conformance/judge/suite.h"

namespace plumb {

struct FingerprintRequest {
  /// The programs, each by the id of its mistake (`./dev mutants`), and the folder of the texts about them.
  std::filesystem::path programs;
  std::filesystem::path known_mistakes;
  /// Of kind image, with envelopes; scenes in a folder with their inputs.
  std::span<const SuiteCase> cases;
  /// A folder for each mistake is made in it.
  std::filesystem::path out;
  std::function<void(const std::string&, double)> progress;
};

/// Has every case drawn by every program with a known mistake, and keeps the pictures that lie outside of the first
/// variant's envelope: fingerprints, by which a wrong submission is recognised.
/// Returns how many mistakes show somewhere. Throws InputError if a program is missing.
int fingerprint_mutants(const FingerprintRequest& request);

}  // namespace plumb
