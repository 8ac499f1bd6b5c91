#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "conformance/compare/fault_search.h"

namespace plumb {
namespace {

/// What a level may become. The reference's colour is known only to be one that is rounded to its level.
struct LevelRange {
  double low = 0, high = 0;
};
using LevelRanges = std::array<LevelRange, 256>;

/// Of the function v^exponent of values from 0 to 1, for each level.
LevelRanges raised_levels(double exponent) {
  LevelRanges ranges;
  for (std::size_t level = 0; level < ranges.size(); ++level) {
    const auto raised = [&](double from) {
      return std::floor(255 * std::pow(std::clamp(from / 255, 0.0, 1.0), exponent) + 0.5);
    };
    const auto middle = static_cast<double>(level);
    ranges[level] = {raised(middle - 0.5), raised(middle + 0.5)};
  }
  return ranges;
}

/// A range that is wider would fit too much: of the darkest levels, a second gamma makes anything from 0 to 15.
constexpr double kWidestRange = 6;

void consider_gamma(const FaultSearch& search, PictureFault fault, const char* sentence, double exponent,
                    std::vector<FoundFault>& found) {
  const LevelRanges ranges = raised_levels(exponent);
  const auto& before = search.reference.samples;
  const auto& after = search.picture.samples;
  std::int64_t still_wrong = 0;
  for (std::size_t pixel = 0; pixel < search.mask.wrong.size() && still_wrong <= search.wrong; ++pixel) {
    bool fits = true, sharp = true;
    for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i) {
      const LevelRange& range = ranges[static_cast<std::size_t>(std::lround(std::clamp(before[i], 0.0F, 255.0F)))];
      const auto level = static_cast<double>(after[i]);
      fits = fits && level >= range.low - search.tolerance && level <= range.high + search.tolerance;
      sharp = sharp && range.high - range.low <= kWidestRange;
    }
    still_wrong += !fits || (!sharp && search.mask.wrong[pixel] != 0) ? 1 : 0;
  }
  if (const auto share = explained_share(search.wrong, still_wrong)) found.push_back({fault, sentence, *share});
}

void find_swapped_channels(const FaultSearch& search, std::vector<FoundFault>& found) {
  static constexpr std::array<const char*, 3> kNames{"red", "green", "blue"};
  std::array<std::size_t, 3> order{0, 1, 2};
  while (std::ranges::next_permutation(order).found) {
    std::int64_t still_wrong = 0;
    for (std::size_t i = 0; i < search.reference.samples.size() && still_wrong <= search.wrong; i += 3) {
      bool fits = true;
      for (std::size_t c = 0; c < 3; ++c)
        fits = fits && std::fabs(static_cast<double>(search.reference.samples[i + order[c]]) -
                                 static_cast<double>(search.picture.samples[i + c])) <= search.tolerance;
      still_wrong += fits ? 0 : 1;
    }
    if (const auto share = explained_share(search.wrong, still_wrong))
      found.push_back({PictureFault::swapped_channels,
                       fmt::format("the channels are written in the order {}, {}, {}", kNames[order[0]],
                                   kNames[order[1]], kNames[order[2]]),
                       *share});
  }
}

}  // namespace

void find_recolorings(const FaultSearch& search, std::vector<FoundFault>& found) {
  constexpr double kGamma = 2.2;  // of renderer/image/image.h
  consider_gamma(search, PictureFault::missing_gamma, "linear colours are written without the gamma of 2.2", kGamma,
                 found);
  consider_gamma(search, PictureFault::double_gamma, "the gamma of 2.2 is applied twice", 1 / kGamma, found);
  find_swapped_channels(search, found);
}

}  // namespace plumb
