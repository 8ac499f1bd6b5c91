#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "renderer/image/image.h"

namespace plumb {

/// Writes `.png` (8-bit levels) or `.exr` (linear, float, unclamped) by the ending, staged: whole or not
/// at all. Throws InputError for another ending or where the file cannot be written.
void write_image(const Image& image, const std::filesystem::path& file);

/// Writes 8-bit levels as they are, three bytes a pixel, rows from the top.
void write_png(std::span<const std::uint8_t> levels, int width, int height, const std::filesystem::path& file);

/// Throws the InputError that write_image would end in for this name: an unknown ending, or as require_writable.
void require_image_writable(const std::filesystem::path& file);

}  // namespace plumb
