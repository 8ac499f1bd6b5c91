#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "conformance/diagnosis/comparison.h"
#include "conformance/diagnosis/likeness.h"

namespace plumb {

/// Two mistakes together, by number.
struct LikelyPair {
  std::array<std::size_t, 2> mistakes{};
  Likeness likeness;
};

/// The pairs, the more alike mistake first, that account for a submission clearly better than the best single one, the
/// likeliest first, at most `most`. `singles`: the likeness of each mistake alone. Only mistakes that show mostly where
/// the submission is wrong are paired.
std::vector<LikelyPair> likely_pairs(std::span<const Deviation> deviations, std::span<const MistakeMatches> mistakes,
                                     std::span<const Likeness> singles, std::size_t most);

/// The same of pairs whose second mistake changes every picture and so hides the first: those of the first are changed
/// for it. Only changes that by themselves account for some of what is wrong are tried.
std::vector<LikelyPair> likely_changed(const Comparison& comparison, std::span<const Fingerprint> fingerprints,
                                       std::span<const Likeness> singles, std::size_t most);

}  // namespace plumb
