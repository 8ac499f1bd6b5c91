#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "conformance/judge/suite.h"
#include "conformance/verdict.h"

namespace plumb {

/// What the envelopes say of one case's picture.
struct JudgedPicture {
  std::string id;
  CheckResult result;
  std::int64_t wrong_pixels = 0;
  /// Undecidable pixels that are not as the reference's.
  std::int64_t moved_pixels = 0;
};

/// A program's pictures, by the variant of which fewest pixels are wrong.
struct JudgedPictures {
  std::string variant;
  /// In the suite's order, those of kind image that have envelopes.
  std::vector<JudgedPicture> cases;
  /// Cases for which there is no picture, or one that cannot be compared.
  std::vector<std::string> unusable;

  std::int64_t wrong_pixels() const;
  std::int64_t moved_pixels() const;
};

/// Judges the pictures `CASE.png` of a folder by the envelopes of a built suite, as `plumb grade` would, but without
/// running anything. Throws InputError for an envelope or reference that cannot be read.
JudgedPictures judge_pictures(const Suite& built, const std::filesystem::path& folder);

}  // namespace plumb
