#include "conformance/diagnosis/likeness.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace plumb {
namespace {

/// The share of a case's pixels at which it has half of the weight that it can have.
constexpr double kHalfWeightShare = 0.005;
/// Of what a mistake that shows in places explains.
constexpr double kInPlaces = 0.8;
constexpr double kAreaPart = 0.5, kAmountPart = 0.25, kDirectionPart = 0.25;

/// Numbers of pixels.
struct Areas {
  std::int64_t subject = 0, mistakes = 0, either = 0;
  std::int64_t agreed = 0;
  /// Where the submission is right although a mistake shows.
  std::int64_t missed = 0;
  /// Where two mistakes show and the submission agrees with neither.
  std::int64_t mixed = 0;
};

Areas areas_of(const Deviation& deviation, const Match* first, const Match* second) {
  const auto word = [](const PixelSet* set, std::size_t i) { return set ? set->words()[i] : 0; };
  Areas areas;
  for (std::size_t i = 0; i < deviation.wrong.words().size(); ++i) {
    const std::uint64_t subject = deviation.wrong.words()[i];
    const std::uint64_t a = word(first ? &first->wrong : nullptr, i), b = word(second ? &second->wrong : nullptr, i);
    if ((subject | a | b) == 0) continue;
    const std::uint64_t agreed =
        word(first ? &first->agrees : nullptr, i) | word(second ? &second->agrees : nullptr, i);
    areas.subject += std::popcount(subject);
    areas.mistakes += std::popcount(a | b);
    areas.either += std::popcount(subject | a | b);
    areas.agreed += std::popcount(agreed);
    areas.missed += std::popcount((a | b) & ~subject);
    areas.mixed += std::popcount(subject & a & b & ~agreed);
  }
  return areas;
}

/// Likenesses of two lists of sums, in [0, 1].
struct BlockLikeness {
  double amount = 0, direction = 0;
};

BlockLikeness compare(const BlockSums& a, const BlockSums* b, const BlockSums* c) {
  double smaller = 0, larger = 0, product = 0, a_squared = 0, b_squared = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double x = a[i], y = (b ? (*b)[i] : 0.0) + (c ? (*c)[i] : 0.0);
    const bool same_sign = x * y > 0;
    smaller += same_sign ? std::min(std::abs(x), std::abs(y)) : 0;
    larger += same_sign ? std::max(std::abs(x), std::abs(y)) : std::abs(x) + std::abs(y);
    product += x * y, a_squared += x * x, b_squared += y * y;
  }
  if (larger == 0 || product <= 0) return {};
  return {smaller / larger, product / std::sqrt(a_squared * b_squared)};
}

BlockLikeness block_likeness(const Deviation& deviation, const Match* first, const Match* second) {
  const BlockSums *a = first ? &first->blocks : nullptr, *b = second ? &second->blocks : nullptr;
  if (!a || !b) return a || b ? compare(deviation.blocks, a, b) : BlockLikeness{};
  // Of two mistakes one may hide the other.
  return std::ranges::max(
      {compare(deviation.blocks, a, b), compare(deviation.blocks, a, nullptr), compare(deviation.blocks, b, nullptr)},
      {}, &BlockLikeness::amount);
}

CaseLikeness case_likeness(const Deviation& deviation, const Match* first, const Match* second) {
  const Areas areas = areas_of(deviation, first, second);
  if (areas.either == 0) return {};
  const double pixels = static_cast<double>(deviation.difference.size() / 3);
  const double either = static_cast<double>(areas.either), counted = either - 0.5 * static_cast<double>(areas.mixed);
  CaseLikeness result{
      either / (either + kHalfWeightShare * pixels), 0, areas.subject, areas.mistakes, areas.agreed, areas.missed};
  if (areas.mistakes == 0) return result;
  const BlockLikeness blocks = block_likeness(deviation, first, second);
  result.value = kAreaPart * static_cast<double>(areas.agreed) / counted + kAmountPart * blocks.amount +
                 kDirectionPart * blocks.direction;
  return result;
}

/// The same of a mistake that shows in places: where it does not show, nothing speaks against it.
CaseLikeness case_likeness_in_places(const Deviation& deviation, const Match* match) {
  CaseLikeness result = case_likeness(deviation, match, nullptr);
  const double pixels = static_cast<double>(deviation.difference.size() / 3), wrong = static_cast<double>(result.wrong);
  result.weight = wrong / (wrong + kHalfWeightShare * pixels);
  result.value = result.wrong == 0 ? 0 : kInPlaces * static_cast<double>(result.agreed) / wrong;
  return result;
}

double share(std::int64_t part, std::int64_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

/// The mean over the cases.
Likeness over_all(std::vector<CaseLikeness> cases) {
  double weights = 0, sum = 0;
  CaseLikeness all;
  for (const CaseLikeness& one : cases) {
    weights += one.weight, sum += one.weight * one.value;
    all.wrong += one.wrong, all.shown += one.shown, all.agreed += one.agreed, all.missed += one.missed;
  }
  return {weights == 0 ? 0 : sum / weights, share(all.agreed, all.wrong), share(all.missed, all.shown),
          std::move(cases)};
}

const Match* match_in(const MistakeMatches& mistake, std::size_t i) {
  return mistake.cases[i] ? &*mistake.cases[i] : nullptr;
}

}  // namespace

Likeness likeness(std::span<const Deviation> deviations, const MistakeMatches& mistake) {
  std::vector<CaseLikeness> cases(deviations.size());
  for (std::size_t i = 0; i < deviations.size(); ++i)
    if (!mistake.unknown[i])
      cases[i] = mistake.in_places ? case_likeness_in_places(deviations[i], match_in(mistake, i))
                                   : case_likeness(deviations[i], match_in(mistake, i), nullptr);
  return over_all(std::move(cases));
}

Likeness likeness_together(std::span<const Deviation> deviations, const MistakeMatches& a, const Likeness& a_alone,
                           const MistakeMatches& b, const Likeness& b_alone) {
  std::vector<CaseLikeness> cases(deviations.size());
  for (std::size_t i = 0; i < deviations.size(); ++i) {
    if (a.unknown[i] || b.unknown[i]) continue;
    if (!b.cases[i])
      cases[i] = a_alone.cases[i];
    else if (!a.cases[i])
      cases[i] = b_alone.cases[i];
    else
      cases[i] = case_likeness(deviations[i], match_in(a, i), match_in(b, i));
  }
  return over_all(std::move(cases));
}

}  // namespace plumb
