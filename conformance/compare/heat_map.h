#pragma once

#include <cstdint>
#include <vector>

#include "conformance/compare/flip.h"
#include "renderer/image/picture.h"

namespace plumb {

/// A picture of where two pictures of the same size and kind differ: three bytes a pixel, rows from the top. Equal
/// pixels show the reference, dark and without colour. Others run from violet (one level, or 1/255 linear) by red and
/// orange to white (255), by the logarithm of the difference, so that one level can be seen.
std::vector<std::uint8_t> heat_map(const Picture& reference, const Picture& picture);

/// A picture of FLIP's errors: three bytes a pixel, rows from the top, from black (0) by violet and orange to pale
/// yellow (1). Brighter is worse everywhere, so that it can be read without colours.
std::vector<std::uint8_t> flip_map(const FlipErrors& errors);

}  // namespace plumb
