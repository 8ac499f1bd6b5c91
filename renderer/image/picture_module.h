#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "renderer/image/picture_header.h"

namespace plumb {

/// What the shared module of the formats that OpenImageIO reads and writes gives. It is a module because that library
/// brings more than two hundred others, which take a fifth of a second to load: most runs need none of them. No
/// exception leaves it but std::bad_alloc.
struct PictureModule {
  /// Decodes an EXR or PPM file whose header has been read. Returns what is wrong with the file; empty if it is right.
  std::string (*decode)(const std::filesystem::path& file, const PictureHeader& header, Picture& picture);
  /// The bytes of an EXR file of floats, three a pixel. Returns what went wrong; empty if nothing did.
  std::string (*encode_exr)(std::span<const float> samples, int width, int height, std::string& bytes);
};

/// Loads the module when it is first asked for; from several threads too. It lies in ../lib/plumb/pictures.so, seen
/// from the program's folder. Throws std::runtime_error if it cannot be loaded.
const PictureModule& picture_module();

}  // namespace plumb
