#pragma once

#include <cstdint>
#include <filesystem>

#include "conformance/verdict.h"
#include "renderer/scene.h"

namespace plumb {

/// How near a picture must come to the reference to be timed.
struct GrowthTolerance {
  /// Levels (or 1/255 linear, for EXR) by which a channel may differ,
  double levels = 3;
  /// and the share of the pixels that may differ by more: edges fall on either side. Of a picture of half the size,
  /// enlarged, 10 to 20 % differ at 100 x 100, 3 to 5 % at 200 x 200, fewer than 1 % from 400 x 400 on.
  double share = 0.02;
};

/// Whether a program rendered the scene in full: its picture must be valid and of the scene's size, and in tiles at
/// random places (4096 pixels in all, or the whole of a smaller picture) equal to our own rendering within the
/// tolerance. One that was kept from another run differs in most; for enlarged ones see GrowthTolerance. `bad_picture`,
/// `wrong_size`, `not_finite`, `different`; pass. The file must exist.
CheckResult check_growth_picture(const std::filesystem::path& picture, const Scene& scene,
                                 const GrowthTolerance& tolerance, std::uint64_t seed);

}  // namespace plumb
