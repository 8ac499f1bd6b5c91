#include "conformance/envelopes/envelope_from_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "conformance/compare/judge_picture.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

std::vector<Picture> read_pictures(const fs::path& folder) {
  std::vector<fs::path> files;
  if (fs::is_directory(folder))
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.path().extension() == ".png" || entry.path().extension() == ".ppm") files.push_back(entry.path());
  if (files.empty()) throw InputError({folder.string()}, "expected a folder with known-correct pictures, PNG or PPM");
  std::ranges::sort(files);
  std::vector<Picture> pictures;
  for (const fs::path& file : files) {
    pictures.push_back(read_reference(file));
    const Picture& p = pictures.back();
    if (p.is_linear()) throw InputError({file.string()}, "is linear, expected 8-bit levels (PNG or PPM)");
    if (p.width != pictures.front().width || p.height != pictures.front().height)
      throw InputError({file.string()},
                       fmt::format("is {}x{}, expected {}x{} as '{}'", p.width, p.height, pictures.front().width,
                                   pictures.front().height, files.front().filename().string()));
  }
  return pictures;
}

std::uint8_t level(float v) { return static_cast<std::uint8_t>(std::clamp(std::lround(v), 0L, 255L)); }

/// Widens the intervals of pixels at edges to their neighbourhoods.
void guess_edges(Envelope& envelope) {
  const std::vector<std::uint8_t> levels = envelope.nominal;
  const auto at = [&](int x, int y, int c) {
    return levels[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(envelope.width) +
                       static_cast<std::size_t>(x)) +
                  static_cast<std::size_t>(c)];
  };
  for (int y = 0; y < envelope.height; ++y)
    for (int x = 0; x < envelope.width; ++x) {
      std::array<int, 3> low, high;
      int step = 0;
      for (int c = 0; c < 3; ++c) {
        low[static_cast<std::size_t>(c)] = high[static_cast<std::size_t>(c)] = at(x, y, c);
        for (int v = std::max(0, y - 1); v <= std::min(envelope.height - 1, y + 1); ++v)
          for (int u = std::max(0, x - 1); u <= std::min(envelope.width - 1, x + 1); ++u) {
            low[static_cast<std::size_t>(c)] = std::min<int>(low[static_cast<std::size_t>(c)], at(u, v, c));
            high[static_cast<std::size_t>(c)] = std::max<int>(high[static_cast<std::size_t>(c)], at(u, v, c));
            step = std::max(step, std::abs(at(u, v, c) - at(x, y, c)));
          }
      }
      if (step <= kEdgeLevels) continue;
      const std::size_t p =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(envelope.width) + static_cast<std::size_t>(x);
      envelope.reasons[p] = PixelReason::silhouette;
      for (std::size_t c = 0; c < 3; ++c) {
        envelope.low[3 * p + c] = static_cast<std::uint8_t>(low[c]);
        envelope.high[3 * p + c] = static_cast<std::uint8_t>(high[c]);
      }
    }
}

}  // namespace

Envelope envelope_from_pictures(const fs::path& folder) {
  const std::vector<Picture> pictures = read_pictures(folder);
  Envelope envelope;
  envelope.guessed = true;
  envelope.width = pictures.front().width, envelope.height = pictures.front().height;
  for (const float v : pictures.front().samples) envelope.nominal.push_back(level(v));
  envelope.low = envelope.high = envelope.nominal;
  envelope.reasons.resize(envelope.nominal.size() / 3);
  for (const Picture& p : pictures)
    for (std::size_t i = 0; i < envelope.nominal.size(); ++i) {
      envelope.low[i] = std::min(envelope.low[i], level(p.samples[i]));
      envelope.high[i] = std::max(envelope.high[i], level(p.samples[i]));
    }
  if (pictures.size() == 1) {
    guess_edges(envelope);
    return envelope;
  }
  for (std::size_t i = 0; i < envelope.nominal.size(); ++i)
    if (envelope.high[i] - envelope.low[i] > 1) envelope.reasons[i / 3] = PixelReason::silhouette;
  return envelope;
}

}  // namespace plumb
