// Pictures that lack something: lines at the border, or detail.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "conformance/compare/fault_search.h"

namespace plumb {
namespace {

/// A row or a column at the border.
struct Line {
  const char* name;
  int x0, y0, x1, y1;
};

bool is_black(const FaultSearch& search, const Line& line) {
  for (int y = line.y0; y < line.y1; ++y)
    for (int x = line.x0; x < line.x1; ++x)
      for (int c = 0; c < 3; ++c)
        if (static_cast<double>(search.picture.pixel(x, y)[c]) > search.tolerance) return false;
  return true;
}

using ChannelRange = std::array<float, 2>;

/// The lowest and the highest level of a channel in a square block.
ChannelRange range_of(const Picture& picture, int x0, int y0, int side, int channel) {
  ChannelRange range{256, -1};
  for (int y = y0; y < y0 + side; ++y) {
    for (int x = x0; x < x0 + side; ++x) {
      const float level = picture.pixel(x, y)[channel];
      range = {std::min(range[0], level), std::max(range[1], level)};
    }
  }
  return range;
}

/// A block where the reference has detail and the picture has one colour, which is a level of the reference there, or
/// between two of them.
struct BlockCounts {
  std::int64_t detailed = 0, flattened = 0;
};

BlockCounts count_blocks(const FaultSearch& search, int side) {
  BlockCounts counts;
  for (int y = 0; y + side <= search.picture.height; y += side) {
    for (int x = 0; x + side <= search.picture.width; x += side) {
      bool detailed = false, flat = true;
      for (int c = 0; c < 3; ++c) {
        const ChannelRange right = range_of(search.reference, x, y, side, c);
        const ChannelRange range = range_of(search.picture, x, y, side, c);
        const auto level = static_cast<double>(range[0]);
        // Twice the tolerance: one colour in the middle would be within it of all of them.
        detailed = detailed || static_cast<double>(right[1]) - static_cast<double>(right[0]) > 2 * search.tolerance;
        flat = flat && range[0] == range[1] && level >= static_cast<double>(right[0]) - search.tolerance &&
               level <= static_cast<double>(right[1]) + search.tolerance;
      }
      counts.detailed += detailed ? 1 : 0;
      counts.flattened += detailed && flat ? 1 : 0;
    }
  }
  return counts;
}

}  // namespace

void find_black_border(const FaultSearch& search, std::vector<FoundFault>& found) {
  const int w = search.picture.width, h = search.picture.height;
  const std::array<Line, 4> lines{{{"top row", 0, 0, w, 1},
                                   {"bottom row", 0, h - 1, w, h},
                                   {"leftmost column", 0, 0, 1, h},
                                   {"rightmost column", w - 1, 0, w, h}}};
  std::string names;
  int x0 = 0, y0 = 0, x1 = w, y1 = h, count = 0;  // what remains without the black lines
  for (const Line& line : lines) {
    if (search.counts.in(line.x0, line.y0, line.x1, line.y1) < kLeastWrongPixels || !is_black(search, line)) continue;
    names += (count++ > 0 ? " and the " : "") + std::string(line.name);
    if (line.y1 == 1) y0 = 1;
    if (line.y0 == h - 1) y1 = h - 1;
    if (line.x1 == 1) x0 = 1;
    if (line.x0 == w - 1) x1 = w - 1;
  }
  if (count == 0) return;
  if (const auto share = explained_share(search.wrong, search.counts.in(x0, y0, x1, y1)))
    found.push_back(
        {PictureFault::black_border, fmt::format("the {} {} black", names, count == 1 ? "is" : "are"), *share});
}

void find_enlargement(const FaultSearch& search, std::vector<FoundFault>& found) {
  for (int side = 4; side >= 2; --side) {  // blocks of 4 are made of blocks of 2
    const BlockCounts blocks = count_blocks(search, side);
    if (const auto share = explained_share(blocks.detailed, blocks.detailed - blocks.flattened)) {
      found.push_back({PictureFault::enlarged,
                       fmt::format("blocks of {0} by {0} pixels have one colour each, as if a smaller picture had been "
                                   "enlarged",
                                   side),
                       *share});
      return;
    }
  }
}

}  // namespace plumb
