#include "renderer/image/picture_header.h"

#include <array>
#include <cctype>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string_view>

#include "renderer/math/input_error.h"
#include "renderer/math/nearest_name.h"

namespace plumb {
namespace {

using Bytes = std::string_view;

[[noreturn]] void bad(const std::string& what) { throw BadPicture(what); }

PictureFormat format_by_name(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  if (equal_ignoring_case(ending, ".png")) return PictureFormat::png;
  if (equal_ignoring_case(ending, ".exr")) return PictureFormat::exr;
  if (equal_ignoring_case(ending, ".ppm")) return PictureFormat::ppm;
  throw InputError({file.string()}, "unknown kind of picture '" + ending + "', expected .png, .exr or .ppm");
}

std::uint32_t big_endian(Bytes b) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(b[i]);
  return value;
}

std::int64_t little_endian(Bytes b) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<unsigned char>(b[i]);
  return static_cast<std::int32_t>(value);
}

struct Size {
  std::int64_t width, height;
};

/// PNG, section 5.2 and 11.2.2: signature, then the IHDR chunk.
Size png_size(Bytes b) {
  constexpr Bytes kSignature("\x89PNG\r\n\x1a\n", 8);
  if (b.substr(0, 8) != kSignature) bad("this is not a PNG file (wrong signature)");
  if (b.size() < 24 || b.substr(12, 4) != "IHDR") bad("the PNG file is cut short or has no header");
  return {big_endian(b.substr(16)), big_endian(b.substr(20))};
}

/// OpenEXR file layout: magic, version, then attributes {name, type, size, value}; dataWindow is a box2i.
Size exr_size(Bytes b) {
  if (b.size() < 8 || b.substr(0, 4) != Bytes("\x76\x2f\x31\x01", 4)) bad("this is not an EXR file (wrong signature)");
  std::size_t at = 8;
  const auto text = [&] {
    const std::size_t end = b.find('\0', at);
    if (end == Bytes::npos) bad("the EXR file is cut short");
    const Bytes word = b.substr(at, end - at);
    at = end + 1;
    return word;
  };
  while (at < b.size() && b[at] != '\0') {
    const Bytes name = text();
    text();
    if (b.size() < at + 4) break;
    const std::int64_t size = little_endian(b.substr(at));
    at += 4;
    if (size < 0 || b.size() - at < static_cast<std::size_t>(size)) break;
    if (name == "dataWindow" && size == 16) {
      return {little_endian(b.substr(at + 8)) - little_endian(b.substr(at)) + 1,
              little_endian(b.substr(at + 12)) - little_endian(b.substr(at + 4)) + 1};
    }
    at += static_cast<std::size_t>(size);
  }
  bad("the EXR file has no data window in its header");
}

/// Netpbm: `P3` or `P6`, then width, height and maximum, separated by white space and # comments.
Size ppm_size(Bytes b) {
  if (b.size() < 2 || b[0] != 'P' || (b[1] != '3' && b[1] != '6'))
    bad("this is not a PPM file (it must begin with P3 or P6)");
  std::size_t at = 2;
  const auto number = [&]() -> std::int64_t {
    while (at < b.size() && (std::isspace(static_cast<unsigned char>(b[at])) || b[at] == '#')) {
      if (b[at] == '#') at = std::min(b.find('\n', at), b.size() - 1);
      ++at;
    }
    std::int64_t value = 0;
    std::size_t digits = 0;
    for (; at < b.size() && b[at] >= '0' && b[at] <= '9' && digits < 9; ++at, ++digits)
      value = value * 10 + (b[at] - '0');
    if (digits == 0) bad("the PPM header is not three whole numbers (width, height, maximum)");
    return value;
  };
  const std::int64_t width = number();
  const std::int64_t height = number();
  const std::int64_t maximum = number();
  if (maximum < 1 || maximum > 65535) bad("the PPM maximum is " + std::to_string(maximum) + ", expected 1 to 65535");
  return {width, height};
}

}  // namespace

PictureHeader read_picture_header(const std::filesystem::path& file) {
  const PictureFormat format = format_by_name(file);
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored))
    throw InputError({file.string()}, "this is a folder, expected a picture");
  if (std::filesystem::exists(file, ignored) && !std::filesystem::is_regular_file(file, ignored))
    throw InputError({file.string()}, "this is no ordinary file, expected a picture");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError({file.string()}, std::string("cannot open the picture: ") + std::strerror(errno));
  std::array<char, 65536> buffer;
  stream.read(buffer.data(), buffer.size());
  const Bytes bytes(buffer.data(), static_cast<std::size_t>(stream.gcount()));
  const Size size = format == PictureFormat::png   ? png_size(bytes)
                    : format == PictureFormat::exr ? exr_size(bytes)
                                                   : ppm_size(bytes);
  if (size.width < 1 || size.height < 1 || size.width > kLargestSide || size.height > kLargestSide ||
      size.width * size.height > kMostPixels) {
    bad("its size is " + std::to_string(size.width) + "x" + std::to_string(size.height) + ", expected 1 to " +
        std::to_string(kLargestSide) + " a side and at most " + std::to_string(kMostPixels) + " pixels");
  }
  return {format, static_cast<int>(size.width), static_cast<int>(size.height)};
}

}  // namespace plumb
