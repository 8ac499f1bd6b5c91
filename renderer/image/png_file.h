#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "renderer/image/picture_header.h"

namespace plumb {

/// Decodes a PNG file whose header has been read: see read_picture. Throws BadPicture if it is damaged or has another
/// size than the header said.
Picture decode_png(const std::filesystem::path& file, const PictureHeader& header);

/// The bytes of a PNG file of 8-bit levels, three a pixel, rows from the top. Throws std::runtime_error if memory is
/// short.
std::string encode_png(std::span<const std::uint8_t> levels, int width, int height);

}  // namespace plumb
