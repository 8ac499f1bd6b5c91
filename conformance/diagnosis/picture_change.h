#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace plumb {

/// What a mistake does to every picture alike, whatever it shows: it moves all pixels, or gives each level another one.
/// Such a mistake can be put on top of any other without drawing the two.
struct PictureChange {
  enum class Move { none, left_right, top_bottom, red_blue };

  Move move = Move::none;
  /// The level that each becomes. Where pixels are moved it is left as it is.
  std::array<std::uint8_t, 256> table{};

  /// The changed picture; three bytes a pixel, rows from the top.
  std::vector<std::uint8_t> apply(std::span<const std::uint8_t> levels, int width, int height) const;
};

/// A case as it should be drawn and as a program with a mistake draws it, of the same size, three bytes a pixel. Kept
/// by the caller.
struct DrawnCase {
  std::span<const std::uint8_t> right, drawn;
  int width = 0, height = 0;
};

/// The change that makes all `drawn` out of `right` but for one pixel in fifty of what differs (programs sample edges
/// differently), to within two levels. Nothing where there is none, as where the pictures show no difference.
std::optional<PictureChange> find_picture_change(std::span<const DrawnCase> cases);

}  // namespace plumb
