#pragma once

#include <filesystem>

#include "renderer/image/picture.h"

namespace plumb {

/// Decodes a PNG, EXR or PPM file. Grey files give three equal channels; alpha is not multiplied in; of an
/// EXR file the channels R, G, B are taken, or else its first three. Throws as read_picture_header, and
/// BadPicture if the content is damaged or cut short. Non-finite EXR values are returned as they are.
Picture read_picture(const std::filesystem::path& file);

}  // namespace plumb
