#include "conformance/diagnosis/likeness.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace plumb {
namespace {

/// The share of a case's pixels at which it has half of the weight that it can have.
constexpr double kHalfWeightShare = 0.005;
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

double case_value(const Areas& areas, const BlockLikeness& blocks) {
  const double counted = static_cast<double>(areas.either) - 0.5 * static_cast<double>(areas.mixed);
  return kAreaPart * static_cast<double>(areas.agreed) / counted + kAmountPart * blocks.amount +
         kDirectionPart * blocks.direction;
}

double share(std::int64_t part, std::int64_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

Likeness likeness(std::span<const Deviation> deviations, std::span<const MistakeMatches* const> mistakes) {
  double weights = 0, sum = 0;
  Areas all;
  for (std::size_t i = 0; i < deviations.size(); ++i) {
    if (std::ranges::any_of(mistakes, [&](const MistakeMatches* m) { return m->unknown[i]; })) continue;
    const auto match = [&](std::size_t k) {
      return k < mistakes.size() && mistakes[k]->cases[i] ? &*mistakes[k]->cases[i] : nullptr;
    };
    const Areas areas = areas_of(deviations[i], match(0), match(1));
    if (areas.either == 0) continue;
    const double pixels = static_cast<double>(deviations[i].difference.size() / 3);
    const double either = static_cast<double>(areas.either), weight = either / (either + kHalfWeightShare * pixels);
    weights += weight;
    sum += weight * case_value(areas, block_likeness(deviations[i], match(0), match(1)));
    all.subject += areas.subject, all.mistakes += areas.mistakes;
    all.agreed += areas.agreed, all.missed += areas.missed;
  }
  return {weights == 0 ? 0 : sum / weights, share(all.agreed, all.subject), share(all.missed, all.mistakes)};
}

}  // namespace plumb
