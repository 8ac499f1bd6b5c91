#pragma once

#include <cstdint>
#include <filesystem>

#include "renderer/image/picture.h"

namespace plumb {

/// What the first bytes of a picture file say.
struct PictureHeader {
  PictureFormat format = PictureFormat::png;
  int width = 0;
  int height = 0;
};

/// Reads signature and size without decoding, so that a picture of an absurd size is refused before
/// it takes memory. Throws InputError if the file cannot be opened or its name ends in none of .png, .exr,
/// .ppm; BadPicture if its content is of another format than its name says, it is cut short, or a side is
/// zero or above kLargestSide, or the pixels are more than kMostPixels.
PictureHeader read_picture_header(const std::filesystem::path& file);

constexpr int kLargestSide = 65535;
constexpr std::int64_t kMostPixels = std::int64_t{1} << 28;

}  // namespace plumb
