#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "conformance/diagnosis/likeness.h"

namespace plumb {

/// Two mistakes together, by number, the more alike one first.
struct LikelyPair {
  std::array<std::size_t, 2> mistakes{};
  Likeness likeness;
};

/// The pairs that account for a submission clearly better than the best single mistake, the likeliest first, at most
/// `most`. `singles`: the likeness of each mistake alone. Only mistakes that show mostly where the submission is wrong
/// are paired.
std::vector<LikelyPair> likely_pairs(std::span<const Deviation> deviations, std::span<const MistakeMatches> mistakes,
                                     std::span<const Likeness> singles, std::size_t most);

}  // namespace plumb
