#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "conformance/compare/fault_search.h"

namespace plumb {
namespace {

constexpr int kFarthestShift = 3;

/// Columns from x0 up to but without x1, rows likewise.
struct Area {
  int x0, y0, x1, y1;
};

/// How many pixels of an area are not what `source` says where they come from: it is given x and y in the picture and
/// returns x and y in the reference. Gives up when there are more than `most`.
template <class Source>
std::int64_t still_wrong(const FaultSearch& search, const Area& area, std::int64_t most, const Source& source) {
  std::int64_t count = 0;
  for (int y = area.y0; y < area.y1 && count <= most; ++y) {
    for (int x = area.x0; x < area.x1; ++x) {
      const auto [from_x, from_y] = source(x, y);
      count += search.agrees(x, y, from_x, from_y) ? 0 : 1;
    }
  }
  return count;
}

struct Place {
  int x, y;
};

std::string shift_sentence(int dx, int dy) {
  std::string sentence = "the whole picture lies";
  const auto pixels = [](int n) { return fmt::format("{} pixel{}", n, n == 1 ? "" : "s"); };
  if (dx != 0) sentence += fmt::format(" {} too far to the {}", pixels(std::abs(dx)), dx > 0 ? "right" : "left");
  if (dx != 0 && dy != 0) sentence += " and";
  if (dy != 0) sentence += fmt::format(" {} too {}", pixels(std::abs(dy)), dy > 0 ? "low" : "high");
  return sentence;
}

/// Pixels that lie nearer to a border than the shift are no evidence for it: whatever is missing there could have moved
/// out of the picture. They may still speak against it.
void find_shift(const FaultSearch& search, std::vector<FoundFault>& found) {
  const int w = search.picture.width, h = search.picture.height;
  std::optional<FoundFault> best;
  for (int distance = 1; distance <= kFarthestShift; ++distance) {  // short ones first: they win where several fit
    for (int dy = -distance; dy <= distance; ++dy) {
      for (int dx = -distance; dx <= distance; ++dx) {
        if (std::max(std::abs(dx), std::abs(dy)) != distance) continue;
        const int mx = std::abs(dx), my = std::abs(dy);
        const std::int64_t wrong = search.counts.in(mx, my, w - mx, h - my);
        const Area common{std::max(dx, 0), std::max(dy, 0), std::min(w, w + dx), std::min(h, h + dy)};
        const auto share = explained_share(wrong, still_wrong(search, common, wrong, [&](int x, int y) {
                                             return Place{x - dx, y - dy};
                                           }));
        if (share && (!best || *share > best->explained))
          best = FoundFault{PictureFault::shift, shift_sentence(dx, dy), *share};
      }
    }
  }
  if (best) found.push_back(*best);
}

}  // namespace

void find_moves(const FaultSearch& search, std::vector<FoundFault>& found) {
  const int w = search.picture.width, h = search.picture.height;
  const Area all{0, 0, w, h};
  const auto consider = [&](PictureFault fault, const char* sentence, const auto& source) {
    if (const auto share = explained_share(search.wrong, still_wrong(search, all, search.wrong, source)))
      found.push_back({fault, sentence, *share});
  };
  consider(PictureFault::flip_left_right, "the picture is mirrored: left and right are exchanged", [&](int x, int y) {
    return Place{w - 1 - x, y};
  });
  consider(PictureFault::flip_top_bottom, "the picture is upside down: top and bottom are exchanged",
           [&](int x, int y) {
             return Place{x, h - 1 - y};
           });
  consider(PictureFault::rotation_180, "the picture is rotated by 180 degrees", [&](int x, int y) {
    return Place{w - 1 - x, h - 1 - y};
  });
  if (w == h)
    consider(PictureFault::transposition, "the picture is transposed: its rows are written as columns",
             [&](int x, int y) {
               return Place{y, x};
             });
  find_shift(search, found);
}

void find_exchanged_sides(const Picture& reference, const Picture& picture, double tolerance,
                          std::vector<FoundFault>& found) {
  // There is no pixel beside pixel to be wrong. A constant reference would fit any constant picture, so what counts is
  // what differs from its first pixel.
  Picture transposed = reference;
  transposed.width = picture.width;
  transposed.height = picture.height;
  Picture constant = transposed;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const std::size_t i =
          3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x));
      std::copy_n(reference.pixel(y, x), 3, transposed.samples.begin() + static_cast<std::ptrdiff_t>(i));
      std::copy_n(reference.pixel(0, 0), 3, constant.samples.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }
  const std::int64_t detail = std::ranges::count(wrong_pixels(transposed, constant, tolerance).wrong, 1);
  const std::int64_t left = std::ranges::count(wrong_pixels(transposed, picture, tolerance).wrong, 1);
  if (const auto share = explained_share(detail, left))
    found.push_back({PictureFault::transposition,
                     "the picture is transposed: width and height, and rows and columns, are exchanged", *share});
}

}  // namespace plumb
