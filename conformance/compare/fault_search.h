#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "conformance/compare/picture_faults.h"
#include "conformance/compare/wrong_regions.h"

namespace plumb {

/// What the search for each kind of fault starts from. The pictures are of one size.
struct FaultSearch {
  FaultSearch(const Picture& reference, const Picture& picture, double tolerance);

  /// Whether a pixel of the picture is a pixel of the reference, within the tolerance.
  bool agrees(int x, int y, int reference_x, int reference_y) const;

  const Picture& reference;
  const Picture& picture;
  double tolerance;
  PixelMask mask;
  WrongCounts counts;
  std::int64_t wrong;
};

/// The share of `wrong` pixels that a hypothesis explains which leaves `still_wrong`; none if that is too little to be
/// named, or the wrong ones are too few.
std::optional<double> explained_share(std::int64_t wrong, std::int64_t still_wrong);

// Each adds what it recognises to `found`.

/// The best shift by whole pixels, flips, rotation_180 and transposition.
void find_moves(const FaultSearch& search, std::vector<FoundFault>& found);
/// Transposition of a picture whose width is the reference's height and the other way round.
void find_exchanged_sides(const Picture& reference, const Picture& picture, double tolerance,
                          std::vector<FoundFault>& found);
/// Gamma and channels.
void find_recolorings(const FaultSearch& search, std::vector<FoundFault>& found);
void find_black_border(const FaultSearch& search, std::vector<FoundFault>& found);
void find_enlargement(const FaultSearch& search, std::vector<FoundFault>& found);
/// None where an enlargement has been found.
void find_half_pixel_shift(const FaultSearch& search, std::vector<FoundFault>& found);

}  // namespace plumb
