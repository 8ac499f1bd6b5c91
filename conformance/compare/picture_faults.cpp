#include "conformance/compare/picture_faults.h"

#include <algorithm>
#include <cmath>

#include "conformance/compare/fault_search.h"

namespace plumb {

std::string to_string(PictureFault fault) {
  switch (fault) {
    case PictureFault::shift:
      return "shift";
    case PictureFault::half_pixel_shift:
      return "half-pixel-shift";
    case PictureFault::flip_left_right:
      return "flip-left-right";
    case PictureFault::flip_top_bottom:
      return "flip-top-bottom";
    case PictureFault::rotation_180:
      return "rotation-180";
    case PictureFault::transposition:
      return "transposition";
    case PictureFault::missing_gamma:
      return "missing-gamma";
    case PictureFault::double_gamma:
      return "double-gamma";
    case PictureFault::swapped_channels:
      return "swapped-channels";
    case PictureFault::black_border:
      return "black-border";
    case PictureFault::enlarged:
      return "enlarged";
  }
  return "unknown";
}

FaultSearch::FaultSearch(const Picture& reference_picture, const Picture& judged_picture, double levels)
    : reference(reference_picture),
      picture(judged_picture),
      tolerance(levels),
      mask(wrong_pixels(reference, picture, levels)),
      counts(mask),
      wrong(counts.in(0, 0, mask.width, mask.height)) {}

bool FaultSearch::agrees(int x, int y, int reference_x, int reference_y) const {
  const float* const p = picture.pixel(x, y);
  const float* const q = reference.pixel(reference_x, reference_y);
  const auto near = [&](int c) {
    return std::fabs(static_cast<double>(p[c]) - static_cast<double>(q[c])) <= tolerance;
  };
  return near(0) && near(1) && near(2);
}

std::optional<double> explained_share(std::int64_t wrong, std::int64_t still_wrong) {
  if (wrong < kLeastWrongPixels) return std::nullopt;
  const double share = 1 - static_cast<double>(still_wrong) / static_cast<double>(wrong);
  if (share < kLeastExplained) return std::nullopt;
  return share;
}

std::vector<FoundFault> picture_faults(const Picture& reference, const Picture& picture, double tolerance) {
  std::vector<FoundFault> found;
  if (reference.width == picture.width && reference.height == picture.height) {
    const FaultSearch search(reference, picture, tolerance);
    if (search.wrong < kLeastWrongPixels) return found;
    find_black_border(search, found);
    find_moves(search, found);
    find_recolorings(search, found);
    find_enlargement(search, found);
    find_half_pixel_shift(search, found);
  } else if (reference.width == picture.height && reference.height == picture.width) {
    find_exchanged_sides(reference, picture, tolerance, found);
  }
  std::ranges::stable_sort(found, std::ranges::greater{}, &FoundFault::explained);
  return found;
}

}  // namespace plumb
