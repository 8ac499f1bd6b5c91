#include "conformance/envelopes/envelope.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "conformance/compare/judge_picture.h"
#include "renderer/image/staged_file.h"
#include "renderer/image/write_image.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

/// So far apart that the reasons can be told by eye.
constexpr int kGreyStep = 60;

/// The levels of a picture that we wrote ourselves.
std::vector<std::uint8_t> read_levels(const fs::path& file, Envelope& envelope) {
  if (!fs::is_regular_file(file)) throw InputError({file.string()}, "this file of the envelope does not exist");
  const Picture picture = read_reference(file);
  if (envelope.width == 0) envelope.width = picture.width, envelope.height = picture.height;
  if (picture.width != envelope.width || picture.height != envelope.height)
    throw InputError({file.string()}, fmt::format("is {}x{}, expected {}x{} as nominal.png", picture.width,
                                                  picture.height, envelope.width, envelope.height));
  std::vector<std::uint8_t> levels(picture.samples.size());
  std::ranges::transform(picture.samples, levels.begin(), [](float v) { return static_cast<std::uint8_t>(v); });
  return levels;
}

}  // namespace

std::string_view to_string(PixelReason reason) {
  static constexpr std::array<std::string_view, kPixelReasons> kNames{"interior", "silhouette", "shadow edge",
                                                                      "reflection", "grazing"};
  return kNames.at(static_cast<std::size_t>(reason));
}

double Envelope::undecidable_share() const {
  if (reasons.empty()) return 0;
  const auto inside = std::ranges::count(reasons, PixelReason::interior);
  return 1 - static_cast<double>(inside) / static_cast<double>(reasons.size());
}

void write_envelope(const Envelope& envelope, const fs::path& folder) {
  fs::create_directories(folder);
  write_png(envelope.nominal, envelope.width, envelope.height, folder / "nominal.png");
  write_png(envelope.low, envelope.width, envelope.height, folder / "low.png");
  write_png(envelope.high, envelope.width, envelope.height, folder / "high.png");
  std::vector<std::uint8_t> grey;
  grey.reserve(3 * envelope.reasons.size());
  for (const PixelReason reason : envelope.reasons)
    grey.insert(grey.end(), 3, static_cast<std::uint8_t>(kGreyStep * static_cast<int>(reason)));
  write_png(grey, envelope.width, envelope.height, folder / "reasons.png");
  fs::remove(folder / "guessed");
  if (envelope.guessed) write_file_staged(folder / "guessed", "made from pictures, without their scene\n");
}

Envelope read_envelope(const fs::path& folder) {
  Envelope envelope;
  envelope.nominal = read_levels(folder / "nominal.png", envelope);
  envelope.low = read_levels(folder / "low.png", envelope);
  envelope.high = read_levels(folder / "high.png", envelope);
  const std::vector<std::uint8_t> grey = read_levels(folder / "reasons.png", envelope);
  for (std::size_t i = 0; i < grey.size(); i += 3) {
    if (grey[i] % kGreyStep != 0 || grey[i] / kGreyStep >= static_cast<int>(kPixelReasons))
      throw InputError({(folder / "reasons.png").string()},
                       fmt::format("holds the grey {}, which is no reason", grey[i]));
    envelope.reasons.push_back(static_cast<PixelReason>(grey[i] / kGreyStep));
  }
  for (std::size_t i = 0; i < envelope.nominal.size(); ++i)
    if (envelope.low[i] > envelope.nominal[i] || envelope.nominal[i] > envelope.high[i])
      throw InputError({folder.string()}, fmt::format("the interval at pixel ({},{}) does not hold the reference",
                                                      i / 3 % static_cast<std::size_t>(envelope.width),
                                                      i / 3 / static_cast<std::size_t>(envelope.width)));
  envelope.guessed = fs::exists(folder / "guessed");
  return envelope;
}

}  // namespace plumb
