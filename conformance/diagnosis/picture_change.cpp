#include "conformance/diagnosis/picture_change.h"

#include <algorithm>
#include <cstdlib>

namespace plumb {
namespace {

using Levels = std::vector<std::uint8_t>;
using Table = std::array<std::uint8_t, 256>;

constexpr int kNearLevels = 2;
/// Of the pixels that a change concerns, how many it may leave unexplained: one in so many.
constexpr std::int64_t kOneUnexplainedIn = 50;

Table unchanged() {
  Table table;
  for (std::size_t i = 0; i < table.size(); ++i) table[i] = static_cast<std::uint8_t>(i);
  return table;
}

bool near(const std::uint8_t* a, const std::uint8_t* b) {
  return std::abs(a[0] - b[0]) <= kNearLevels && std::abs(a[1] - b[1]) <= kNearLevels &&
         std::abs(a[2] - b[2]) <= kNearLevels;
}

/// For each level the one that it most often becomes; between those that occur, in proportion.
Table most_frequent_levels(std::span<const DrawnCase> cases) {
  std::vector<std::int64_t> counts(256 * 256);
  for (const DrawnCase& c : cases)
    for (std::size_t i = 0; i < c.right.size(); ++i) ++counts[256u * c.right[i] + c.drawn[i]];
  Table table = unchanged();
  int before = -1;
  for (int level = 0; level < 256; ++level) {
    const auto row = counts.begin() + 256 * level;
    const auto most = std::max_element(row, row + 256);
    if (*most == 0) continue;
    table[static_cast<std::size_t>(level)] = static_cast<std::uint8_t>(most - row);
    for (int k = before + 1; before >= 0 && k < level; ++k) {
      const int low = table[static_cast<std::size_t>(before)], high = table[static_cast<std::size_t>(level)];
      table[static_cast<std::size_t>(k)] =
          static_cast<std::uint8_t>(low + (high - low) * (k - before) / (level - before));
    }
    before = level;
  }
  return table;
}

/// Whether the change makes the pictures, counting pixels that differ from the right ones before or after it.
bool explains(const PictureChange& change, std::span<const DrawnCase> cases) {
  std::int64_t concerned = 0, unexplained = 0;
  for (const DrawnCase& c : cases) {
    const Levels changed = change.apply(c.right, c.width, c.height);
    for (std::size_t i = 0; i < changed.size(); i += 3) {
      if (near(&c.right[i], &c.drawn[i]) && near(&c.right[i], &changed[i])) continue;
      ++concerned;
      unexplained += !near(&changed[i], &c.drawn[i]);
    }
  }
  return concerned > 0 && unexplained * kOneUnexplainedIn <= concerned;
}

}  // namespace

std::vector<std::uint8_t> PictureChange::apply(std::span<const std::uint8_t> levels, int width, int height) const {
  Levels changed(levels.size());
  const auto w = static_cast<std::size_t>(width), h = static_cast<std::size_t>(height);
  for (std::size_t y = 0; y < h; ++y)
    for (std::size_t x = 0; x < w; ++x) {
      const std::size_t from_x = move == Move::left_right ? w - 1 - x : x;
      const std::size_t from_y = move == Move::top_bottom ? h - 1 - y : y;
      const std::uint8_t* from = &levels[3 * (from_y * w + from_x)];
      for (std::size_t k = 0; k < 3; ++k)
        changed[3 * (y * w + x) + k] = table[from[move == Move::red_blue ? 2 - k : k]];
    }
  return changed;
}

std::optional<PictureChange> find_picture_change(std::span<const DrawnCase> cases) {
  using enum PictureChange::Move;
  for (const PictureChange::Move move : {left_right, top_bottom, red_blue})
    if (const PictureChange change{move, unchanged()}; explains(change, cases)) return change;
  if (const PictureChange change{none, most_frequent_levels(cases)}; explains(change, cases)) return change;
  return std::nullopt;
}

}  // namespace plumb
