#include "conformance/diagnosis/pairs.h"

#include <algorithm>

namespace plumb {
namespace {

/// A second mistake can always be found that accounts for some more pixels. A real one closes more than this part of
/// what the best single mistake leaves open, and this much besides.
constexpr double kLeastPart = 0.3, kLeastGain = 0.01;
/// Of the area where a mistake shows that the submission may lack it in, and be paired.
constexpr double kMostMissed = 0.4;
constexpr std::size_t kMostFirst = 12, kMostSecond = 40;
/// Of mistakes that change every picture: how alike such a one has to be by itself, and how many are tried.
constexpr double kLeastChange = 0.1;
constexpr std::size_t kMostChanges = 2;

/// At most `most` numbers, those with the largest values first.
template <class Value>
std::vector<std::size_t> largest(std::vector<std::size_t> numbers, std::size_t most, Value value) {
  std::ranges::stable_sort(numbers, std::ranges::greater{}, value);
  if (numbers.size() > most) numbers.resize(most);
  return numbers;
}

/// The share of the area where a mistake shows in which the submission agrees with it.
double precision(const Likeness& single) {
  std::int64_t agreed = 0, shown = 0;
  for (const CaseLikeness& one : single.cases) agreed += one.agreed, shown += one.shown;
  return shown == 0 ? 0 : static_cast<double>(agreed) / static_cast<double>(shown);
}

/// The likeness from which on a pair is worth more than the best single mistake.
double least_of_pairs(std::span<const Likeness> singles) {
  double best = 0;
  for (const Likeness& single : singles) best = std::max(best, single.value);
  return best + kLeastPart * (1 - best) + kLeastGain;
}

std::vector<LikelyPair> likeliest(std::vector<LikelyPair> pairs, std::size_t most) {
  std::ranges::stable_sort(pairs, std::ranges::greater{}, [](const LikelyPair& p) { return p.likeness.value; });
  if (pairs.size() > most) pairs.resize(most);
  return pairs;
}

}  // namespace

std::vector<LikelyPair> likely_pairs(std::span<const Deviation> deviations, std::span<const MistakeMatches> mistakes,
                                     std::span<const Likeness> singles, std::size_t most) {
  std::vector<std::size_t> usable;
  for (std::size_t i = 0; i < singles.size(); ++i)
    if (singles[i].explained > 0 && singles[i].missed <= kMostMissed) usable.push_back(i);
  // One of the two accounts for much; the other may show in one case of many, but there it agrees.
  const auto firsts = largest(usable, kMostFirst, [&](std::size_t i) { return singles[i].value; });
  const auto seconds = largest(usable, kMostSecond, [&](std::size_t i) { return precision(singles[i]); });
  const double least = least_of_pairs(singles);
  std::vector<LikelyPair> pairs;
  for (std::size_t a = 0; a < firsts.size(); ++a)
    for (const std::size_t i : seconds) {
      const auto end = firsts.begin() + static_cast<std::ptrdiff_t>(a) + 1;
      if (std::find(firsts.begin(), end, i) != end) continue;  // itself, or had in the other order
      Likeness together =
          likeness_together(deviations, mistakes[firsts[a]], singles[firsts[a]], mistakes[i], singles[i]);
      if (together.value >= least) pairs.push_back({{firsts[a], i}, std::move(together)});
    }
  return likeliest(std::move(pairs), most);
}

std::vector<LikelyPair> likely_changed(const Comparison& comparison, std::span<const Fingerprint> fingerprints,
                                       std::span<const Likeness> singles, std::size_t most) {
  std::vector<std::size_t> usable;
  for (std::size_t i = 0; i < singles.size(); ++i)
    if (fingerprints[i].change && singles[i].value >= kLeastChange) usable.push_back(i);
  const double least = least_of_pairs(singles);
  std::vector<LikelyPair> pairs;
  for (const std::size_t change : largest(usable, kMostChanges, [&](std::size_t i) { return singles[i].value; }))
    for (std::size_t i = 0; i < fingerprints.size(); ++i) {
      if (i == change || !fingerprints[i].parts.empty()) continue;
      Likeness together =
          likeness(comparison.deviations(), comparison.matches(fingerprints[i], *fingerprints[change].change));
      if (together.value >= least) pairs.push_back({{i, change}, std::move(together)});
    }
  return likeliest(std::move(pairs), most);
}

}  // namespace plumb
