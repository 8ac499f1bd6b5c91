#include "conformance/diagnosis/evidence_pixels.h"

#include <cstdlib>
#include <utility>

namespace plumb {
namespace {

/// How many of the 3 x 3 pixels around (x, y) are in the set.
int neighbours_in(const PixelSet& set, int x, int y, int width, int height) {
  int count = 0;
  for (int v = y - 1; v <= y + 1; ++v)
    for (int u = x - 1; u <= x + 1; ++u)
      if (u >= 0 && u < width && v >= 0 && v < height)
        count +=
            set.contains(static_cast<std::size_t>(v) * static_cast<std::size_t>(width) + static_cast<std::size_t>(u));
  return count;
}

std::array<std::uint8_t, 3> levels_at(std::span<const std::uint8_t> levels, std::size_t pixel) {
  return {levels[3 * pixel], levels[3 * pixel + 1], levels[3 * pixel + 2]};
}

}  // namespace

std::optional<DiagnosisPixel> evidence_pixel(const DiagnosisCase& picture, const EvidenceLimits& limits,
                                             const Deviation& deviation, std::span<const std::uint8_t> suspected) {
  const PixelSet agrees = match_of(suspected, deviation, limits).agrees;
  std::optional<std::size_t> best;
  std::pair<int, int> best_rank;
  const auto width = static_cast<std::size_t>(limits.width());
  for (std::size_t i = 0; i < limits.pixels(); ++i) {
    if (!agrees.contains(i)) continue;
    const std::int16_t* off = &deviation.difference[3 * i];
    const std::pair rank{neighbours_in(agrees, static_cast<int>(i % width), static_cast<int>(i / width), limits.width(),
                                       limits.height()),
                         std::abs(off[0]) + std::abs(off[1]) + std::abs(off[2])};
    if (!best || rank > best_rank) best = i, best_rank = rank;
  }
  if (!best) return std::nullopt;
  return DiagnosisPixel{picture.id,
                        static_cast<int>(*best % width),
                        static_cast<int>(*best / width),
                        levels_at(limits.nominal(), *best),
                        levels_at(picture.levels, *best),
                        levels_at(suspected, *best)};
}

}  // namespace plumb
