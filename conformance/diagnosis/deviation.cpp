#include "conformance/diagnosis/deviation.h"

#include <algorithm>
#include <cstdlib>

namespace plumb {
namespace {

constexpr int kBlockSide = 8;
/// Of colours that are called nearly the same.
constexpr int kNearLevels = 2, kNearPart = 16;

std::size_t blocks_across(int width) { return static_cast<std::size_t>((width + kBlockSide - 1) / kBlockSide); }

BlockSums no_blocks(const EvidenceLimits& limits) {
  return BlockSums(3 * blocks_across(limits.width()) * blocks_across(limits.height()));
}

/// Adds what is off at a pixel to its square.
class BlockAdder {
 public:
  BlockAdder(const EvidenceLimits& limits, BlockSums& sums)
      : width_(static_cast<std::size_t>(limits.width())), across_(blocks_across(limits.width())), sums_(sums) {}
  void add(std::size_t pixel, const std::array<int, 3>& difference) {
    float* sum = &sums_[3 * (pixel / width_ / kBlockSide * across_ + pixel % width_ / kBlockSide)];
    for (std::size_t k = 0; k < 3; ++k) sum[k] += static_cast<float>(difference[k]);
  }

 private:
  std::size_t width_, across_;
  BlockSums& sums_;
};

std::array<int, 3> difference_at(std::size_t pixel, std::span<const std::uint8_t> levels,
                                 std::span<const std::uint8_t> nominal) {
  std::array<int, 3> difference{};
  for (std::size_t k = 0; k < 3; ++k) difference[k] = levels[3 * pixel + k] - nominal[3 * pixel + k];
  return difference;
}

bool nearly_same(const std::array<int, 3>& a, const std::int16_t* b) {
  for (std::size_t k = 0; k < 3; ++k)
    if (std::abs(a[k] - b[k]) > kNearLevels + std::abs(b[k]) / kNearPart) return false;
  return true;
}

}  // namespace

EvidenceLimits::EvidenceLimits(const Envelope& envelope, int tolerance)
    : envelope_(&envelope), low_(envelope.low.size()), high_(envelope.high.size()) {
  for (std::size_t i = 0; i < low_.size(); ++i) {
    const bool interior = envelope.reasons[i / 3] == PixelReason::interior;
    const int slack = tolerance + (interior ? 0 : envelope.high[i] - envelope.low[i]);
    low_[i] = static_cast<std::uint8_t>(std::max(0, envelope.low[i] - slack));
    high_[i] = static_cast<std::uint8_t>(std::min(255, envelope.high[i] + slack));
  }
}

Deviation deviation_of(std::span<const std::uint8_t> levels, const EvidenceLimits& limits) {
  Deviation deviation{PixelSet(limits.pixels()), std::vector<std::int16_t>(levels.size()), no_blocks(limits)};
  BlockAdder blocks(limits, deviation.blocks);
  for (std::size_t i = 0; i < limits.pixels(); ++i) {
    if (!limits.is_wrong(i, &levels[3 * i])) continue;
    const std::array<int, 3> difference = difference_at(i, levels, limits.nominal());
    deviation.wrong.insert(i);
    for (std::size_t k = 0; k < 3; ++k) deviation.difference[3 * i + k] = static_cast<std::int16_t>(difference[k]);
    blocks.add(i, difference);
  }
  return deviation;
}

Match match_of(std::span<const std::uint8_t> levels, const Deviation& deviation, const EvidenceLimits& limits) {
  Match match{PixelSet(limits.pixels()), PixelSet(limits.pixels()), no_blocks(limits)};
  BlockAdder blocks(limits, match.blocks);
  for (std::size_t i = 0; i < limits.pixels(); ++i) {
    if (!limits.is_wrong(i, &levels[3 * i])) continue;
    const std::array<int, 3> difference = difference_at(i, levels, limits.nominal());
    match.wrong.insert(i);
    blocks.add(i, difference);
    if (deviation.wrong.contains(i) && nearly_same(difference, &deviation.difference[3 * i])) match.agrees.insert(i);
  }
  return match;
}

}  // namespace plumb
