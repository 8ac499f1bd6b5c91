#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

namespace plumb {

/// Why a correct program may answer differently at a pixel: what first changed where the reference was disturbed.
enum class PixelReason : std::uint8_t {
  interior,     ///< nothing: the pixel has one right colour, up to rounding
  silhouette,   ///< another surface is seen
  shadow_edge,  ///< the first surface is lit by other lights
  reflection,   ///< further along the path another surface is met, or it is lit otherwise
  grazing,      ///< the same path, but its colour magnifies rounding errors
};
constexpr std::size_t kPixelReasons = 5;
std::string_view to_string(PixelReason reason);

/// What correct programs may write: for each pixel and channel the closed interval of 8-bit levels. Rows from the top.
struct Envelope {
  int width = 0, height = 0;
  /// Three bytes a pixel: what the reference writes, and the ends of the interval around it.
  std::vector<std::uint8_t> nominal, low, high;
  /// One a pixel.
  std::vector<PixelReason> reasons;
  /// Made from pictures alone, without their scene: where a correct program may differ was guessed.
  bool guessed = false;

  std::size_t pixels() const { return reasons.size(); }
  /// The share of the pixels that are not interior; 0 for an empty picture.
  double undecidable_share() const;
  friend bool operator==(const Envelope&, const Envelope&) = default;
};

/// Writes `nominal.png`, `low.png`, `high.png` and `reasons.png` (grey: 60 times the reason's number) into the folder,
/// and the file `guessed` where it is. The same envelope gives the same bytes.
void write_envelope(const Envelope& envelope, const std::filesystem::path& folder);

/// Reads what write_envelope wrote. Throws InputError, naming the file, if one is missing, of another size, no PNG, or
/// if somewhere low <= nominal <= high does not hold.
Envelope read_envelope(const std::filesystem::path& folder);

}  // namespace plumb
