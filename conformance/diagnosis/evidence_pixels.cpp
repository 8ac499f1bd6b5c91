#include "conformance/diagnosis/evidence_pixels.h"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <set>
#include <utility>

namespace plumb {
namespace {

constexpr std::size_t kMostPixels = 3;

/// A case in which a drawing agrees with the submission.
struct Place {
  std::int64_t agreed = 0;
  std::size_t drawing = 0, picture = 0;
};

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

DiagnosisPixel best_pixel(const Comparison& comparison, std::size_t picture, std::span<const std::uint8_t> suspected) {
  const EvidenceLimits& limits = comparison.limits(picture);
  const Deviation& deviation = comparison.deviations()[picture];
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
  const DiagnosisCase& of = comparison.cases()[picture];
  return {of.id,
          static_cast<int>(*best % width),
          static_cast<int>(*best / width),
          levels_at(limits.nominal(), *best),
          levels_at(of.levels, *best),
          levels_at(suspected, *best)};
}

/// Those where something agrees, the largest areas first.
std::vector<Place> places_of(const Comparison& comparison, std::span<const SuspectedDrawing> drawings) {
  std::vector<Place> places;
  for (std::size_t d = 0; d < drawings.size(); ++d)
    for (std::size_t i = 0; i < comparison.cases().size(); ++i) {
      const std::vector<std::uint8_t> levels = comparison.levels(*drawings[d].mistake, i, drawings[d].change);
      const std::int64_t agreed = match_of(levels, comparison.deviations()[i], comparison.limits(i)).agrees.count();
      if (agreed > 0) places.push_back({agreed, d, i});
    }
  std::ranges::stable_sort(places, std::ranges::greater{}, &Place::agreed);
  return places;
}

/// The first place of each drawing, then the rest.
std::vector<Place> each_drawing_first(std::vector<Place> places) {
  std::set<std::size_t> had;
  std::ranges::stable_partition(places, [&](const Place& p) { return had.insert(p.drawing).second; });
  return places;
}

}  // namespace

std::vector<DiagnosisPixel> evidence_pixels(const Comparison& comparison, std::span<const SuspectedDrawing> drawings) {
  std::vector<DiagnosisPixel> pixels;
  std::set<std::size_t> shown;
  for (const Place& place : each_drawing_first(places_of(comparison, drawings))) {
    if (pixels.size() == kMostPixels) break;
    if (!shown.insert(place.picture).second) continue;
    const SuspectedDrawing& drawing = drawings[place.drawing];
    pixels.push_back(
        best_pixel(comparison, place.picture, comparison.levels(*drawing.mistake, place.picture, drawing.change)));
  }
  return pixels;
}

}  // namespace plumb
