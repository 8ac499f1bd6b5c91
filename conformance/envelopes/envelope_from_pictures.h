#pragma once

#include <filesystem>

#include "conformance/envelopes/envelope.h"

namespace plumb {

/// An envelope from known-correct pictures of one scene, the PNG and PPM files of the folder, for a course whose scenes
/// we cannot read. Marked as `guessed`: weaker than one that was derived.
///
/// From several: the hull of what they have at each pixel; where it spans more than a level, the pixel is undecidable.
/// From one: a pixel that differs from one of its eight neighbours by more than kEdgeLevels in a channel lies at an
/// edge, which a correct program may have on its other side: its interval is that of its neighbourhood.
///
/// Throws InputError if there is no picture, or one is invalid, linear, or of another size.
Envelope envelope_from_pictures(const std::filesystem::path& folder);

/// What smooth shading does not change by from pixel to pixel.
constexpr int kEdgeLevels = 24;

}  // namespace plumb
