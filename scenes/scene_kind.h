#pragma once

#include "scenes/kind.h"

namespace plumb {

/// The root element, and the one structural surface: a group has no shape of its own.
extern const Kind scene_kind;
extern const Kind group_kind;

/// The largest maximum depth: tracing is recursive.
constexpr int kDeepestPath = 1000;

/// The most pixels and the longest side a picture may have.
constexpr int kLargestImageSide = 65535;
constexpr long kMostImagePixels = 1L << 28;

}  // namespace plumb
