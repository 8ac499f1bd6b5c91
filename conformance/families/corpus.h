#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>

#include "conformance/families/family.h"

namespace plumb {

struct CorpusRequest {
  const FamilyKind* family = nullptr;
  std::int64_t count = 0;
  std::uint64_t seed = 1;
  plumb_precision precision = PLUMB_FLOAT;
};

/// Writes `count` rays of a family with their exact answers (plumb_corpus.h), the same rays in the same order as `plumb
/// check` asks for the same seed; whole cases, so up to a case's rays more. Returns how many. Staged and renamed: no
/// reader sees half a file. Throws InputError if it cannot be written, and for a family of meshes.
std::int64_t export_corpus(
    const CorpusRequest& request, const std::filesystem::path& file,
    const std::function<void(double)>& progress = [](double) {});

}  // namespace plumb
