#include "conformance/diagnosis/pairs.h"

#include <algorithm>
#include <map>

namespace plumb {
namespace {

/// A second mistake can always be found that accounts for some more pixels. A real one closes more than this part of
/// what the best single mistake leaves open, and this much besides.
constexpr double kLeastPart = 0.3, kLeastGain = 0.01;
/// Of the area where a mistake shows that the submission may lack it in, and be paired.
constexpr double kMostMissed = 0.4;
constexpr std::size_t kMostFirst = 12, kMostSecond = 40;
/// Of mistakes that change every picture: what share such a one has to explain by itself, and how many are tried.
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

std::vector<std::size_t> likely_changes(const Comparison& comparison, std::span<const Fingerprint> fingerprints) {
  std::map<std::size_t, double> explained;
  for (std::size_t i = 0; i < fingerprints.size(); ++i) {
    if (!fingerprints[i].change) continue;
    const Likeness alone = likeness(comparison.deviations(), comparison.matches(fingerprints[i]).front());
    if (alone.explained >= kLeastChange) explained[i] = alone.explained;
  }
  std::vector<std::size_t> changes;
  for (const auto& [i, share] : explained) changes.push_back(i);
  return largest(std::move(changes), kMostChanges, [&](std::size_t i) { return explained.at(i); });
}

std::vector<LikelyPair> likely_changed(std::span<const std::size_t> changes,
                                       std::span<const std::vector<Likeness>> changed,
                                       std::span<const Fingerprint> fingerprints, std::span<const Likeness> singles,
                                       std::size_t most) {
  const double least = least_of_pairs(singles);
  std::vector<LikelyPair> pairs;
  for (std::size_t i = 0; i < changed.size(); ++i)
    for (std::size_t k = 0; k < changes.size(); ++k)
      if (i != changes[k] && fingerprints[i].parts.empty() && !fingerprints[i].in_places &&
          changed[i][k].value >= least)
        pairs.push_back({{i, changes[k]}, changed[i][k]});
  return likeliest(std::move(pairs), most);
}

}  // namespace plumb
