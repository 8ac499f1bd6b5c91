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

/// Mistakes that change every picture and by themselves explain some of what is wrong, by number, those that explain
/// most first: worth putting on top of all others. Two at most.
std::vector<std::size_t> likely_changes(const Comparison& comparison, std::span<const Fingerprint> fingerprints);

/// The pairs of a mistake and one of these `changes` on top that account for a submission clearly better than the best
/// single mistake, the likeliest first, at most `most`. `changed[i][k]`: the likeness of mistake i under `changes[k]`.
std::vector<LikelyPair> likely_changed(std::span<const std::size_t> changes,
                                       std::span<const std::vector<Likeness>> changed,
                                       std::span<const Fingerprint> fingerprints, std::span<const Likeness> singles,
                                       std::size_t most);

}  // namespace plumb
