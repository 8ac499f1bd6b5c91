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

}  // namespace

std::vector<LikelyPair> likely_pairs(std::span<const Deviation> deviations, std::span<const MistakeMatches> mistakes,
                                     std::span<const Likeness> singles, std::size_t most) {
  double best_single = 0;
  std::vector<std::size_t> usable;
  for (std::size_t i = 0; i < singles.size(); ++i) {
    best_single = std::max(best_single, singles[i].value);
    if (singles[i].explained > 0 && singles[i].missed <= kMostMissed) usable.push_back(i);
  }
  // One of the two accounts for much; the other may show in one case of many, but there it agrees.
  const auto firsts = largest(usable, kMostFirst, [&](std::size_t i) { return singles[i].value; });
  const auto seconds = largest(usable, kMostSecond, [&](std::size_t i) { return precision(singles[i]); });
  const double least = best_single + kLeastPart * (1 - best_single) + kLeastGain;
  std::vector<LikelyPair> pairs;
  for (std::size_t a = 0; a < firsts.size(); ++a)
    for (const std::size_t i : seconds) {
      const auto end = firsts.begin() + static_cast<std::ptrdiff_t>(a) + 1;
      if (std::find(firsts.begin(), end, i) != end) continue;  // itself, or had in the other order
      Likeness together =
          likeness_together(deviations, mistakes[firsts[a]], singles[firsts[a]], mistakes[i], singles[i]);
      if (together.value >= least) pairs.push_back({{firsts[a], i}, std::move(together)});
    }
  std::ranges::stable_sort(pairs, std::ranges::greater{}, [](const LikelyPair& p) { return p.likeness.value; });
  if (pairs.size() > most) pairs.resize(most);
  return pairs;
}

}  // namespace plumb
