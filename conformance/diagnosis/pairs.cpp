#include "conformance/diagnosis/pairs.h"

#include <algorithm>

namespace plumb {
namespace {

/// A second mistake can always be found that accounts for some more pixels; a real one adds more than this to the
/// likeness.
constexpr double kLeastGain = 0.06;
/// Of the area where a mistake shows that the submission may lack it in, and be paired.
constexpr double kMostMissed = 0.4;
constexpr std::size_t kMostCandidates = 24;

std::vector<std::size_t> candidates(std::span<const Likeness> singles) {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < singles.size(); ++i)
    if (singles[i].explained > 0 && singles[i].missed <= kMostMissed) numbers.push_back(i);
  std::ranges::stable_sort(numbers, std::ranges::greater{}, [&](std::size_t i) { return singles[i].value; });
  if (numbers.size() > kMostCandidates) numbers.resize(kMostCandidates);
  return numbers;
}

}  // namespace

std::vector<LikelyPair> likely_pairs(std::span<const Deviation> deviations, std::span<const MistakeMatches> mistakes,
                                     std::span<const Likeness> singles, std::size_t most) {
  const std::vector<std::size_t> numbers = candidates(singles);
  std::vector<LikelyPair> pairs;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    for (std::size_t k = i + 1; k < numbers.size(); ++k) {
      const std::array<const MistakeMatches*, 2> both{&mistakes[numbers[i]], &mistakes[numbers[k]]};
      const Likeness together = likeness(deviations, both);
      if (together.value >= singles[numbers[i]].value + kLeastGain)
        pairs.push_back({{numbers[i], numbers[k]}, together});
    }
  std::ranges::stable_sort(pairs, std::ranges::greater{}, [](const LikelyPair& p) { return p.likeness.value; });
  if (pairs.size() > most) pairs.resize(most);
  return pairs;
}

}  // namespace plumb
