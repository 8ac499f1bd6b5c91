#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "conformance/diagnosis/pixel_set.h"
#include "conformance/envelopes/envelope.h"

namespace plumb {

/// The levels outside of which a pixel counts as evidence of a mistake. In the interior that is what judging allows; an
/// undecidable pixel counts only where it lies further outside of its interval than that is wide, as the interval
/// itself was found by a few trials.
class EvidenceLimits {
 public:
  EvidenceLimits(const Envelope& envelope, int tolerance);

  int width() const { return envelope_->width; }
  int height() const { return envelope_->height; }
  std::size_t pixels() const { return envelope_->pixels(); }
  std::span<const std::uint8_t> nominal() const { return envelope_->nominal; }
  /// Whether the three levels at `levels` are evidence at this pixel.
  bool is_wrong(std::size_t pixel, const std::uint8_t* levels) const {
    const std::uint8_t *low = &low_[3 * pixel], *high = &high_[3 * pixel];
    return levels[0] < low[0] || levels[0] > high[0] || levels[1] < low[1] || levels[1] > high[1] ||
           levels[2] < low[2] || levels[2] > high[2];
  }

 private:
  const Envelope* envelope_;
  std::vector<std::uint8_t> low_, high_;
};

/// What a picture is off by, added up in squares of 8 x 8 pixels: what is left of a pattern whose single pixels are
/// random. Three sums a square, of signed levels.
using BlockSums = std::vector<float>;

/// Where a picture of one case is wrong, and by how much.
struct Deviation {
  PixelSet wrong;
  /// Three a pixel: levels less the nominal ones; 0 where the pixel is right.
  std::vector<std::int16_t> difference;
  BlockSums blocks;
};

/// `levels`: three bytes a pixel, of the size of the limits.
Deviation deviation_of(std::span<const std::uint8_t> levels, const EvidenceLimits& limits);

/// Another picture of the same case, held against a deviation.
struct Match {
  /// Where the other picture is wrong.
  PixelSet wrong;
  /// Where both are wrong and of nearly the same colour.
  PixelSet agrees;
  BlockSums blocks;
};

/// `levels`: of the other picture. Colours are nearly the same within 2 levels and a sixteenth of what the deviation is
/// off by: programs with the same mistake differ in precision, and their formulas in the last step.
Match match_of(std::span<const std::uint8_t> levels, const Deviation& deviation, const EvidenceLimits& limits);

}  // namespace plumb
