#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace plumb {

/// The path of a file in a folder that no other process uses. The folder exists.
inline std::filesystem::path picture_test_file(const std::string& name) {
  struct Folder {
    ~Folder() { std::filesystem::remove_all(path); }
    std::filesystem::path path =
        std::filesystem::path(::testing::TempDir()) / ("plumb-image-" + std::to_string(getpid()));
  };
  static const Folder of_this_process;
  const std::filesystem::path& folder = of_this_process.path;
  std::filesystem::create_directories(folder);
  return folder / name;
}

inline std::filesystem::path write_picture_test_file(const std::string& name, const std::string& bytes) {
  const auto file = picture_test_file(name);
  std::ofstream(file, std::ios::binary | std::ios::trunc)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return file;
}

inline std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline std::string big_endian_bytes(std::uint32_t value, int count = 4) {
  std::string bytes;
  for (int shift = 8 * (count - 1); shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xff);
  return bytes;
}

inline std::string little_endian_bytes(std::uint32_t value, int count = 4) {
  const std::string bytes = big_endian_bytes(value, count);
  return {bytes.rbegin(), bytes.rend()};
}

/// A chunk of a PNG file: length, type, data and the CRC of the last two [PNG, section 5.3].
inline std::string png_chunk(const std::string& type, const std::string& data) {
  std::uint32_t crc = 0xffffffff;
  for (const char c : type + data) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = crc & 1 ? crc >> 1 ^ 0xedb88320 : crc >> 1;
  }
  return big_endian_bytes(static_cast<std::uint32_t>(data.size())) + type + data + big_endian_bytes(~crc);
}

/// The header of a PNG file. Colour types: 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGB and alpha.
inline std::string png_header(std::uint32_t width, std::uint32_t height, int depth, int color_type) {
  return "\x89PNG\r\n\x1a\n" +
         png_chunk("IHDR", big_endian_bytes(width) + big_endian_bytes(height) + static_cast<char>(depth) +
                               static_cast<char>(color_type) + std::string(3, '\0'));
}

/// zlib's format with one stored block [RFC 1950, 1951].
inline std::string zlib_stored(const std::string& data) {
  std::uint32_t a = 1, b = 0;
  for (const char c : data) {
    a = (a + static_cast<unsigned char>(c)) % 65521;
    b = (b + a) % 65521;
  }
  const auto size = static_cast<std::uint32_t>(data.size());
  return std::string("\x78\x01\x01", 3) + little_endian_bytes(size, 2) + little_endian_bytes(~size & 0xffff, 2) + data +
         big_endian_bytes(b << 16 | a);
}

/// A whole PNG file; `scanlines` holds a filter byte 0 and the packed samples for each row, `before` the chunks before
/// them.
inline std::string png_bytes(std::uint32_t width, std::uint32_t height, int depth, int color_type,
                             const std::string& scanlines, const std::string& before = "") {
  return png_header(width, height, depth, color_type) + before + png_chunk("IDAT", zlib_stored(scanlines)) +
         png_chunk("IEND", "");
}

/// The start of an EXR file up to its data window, which lies from (0,0) to (right, bottom).
inline std::string exr_header(std::uint32_t right, std::uint32_t bottom) {
  using namespace std::string_literals;
  return "\x76\x2f\x31\x01\x02\0\0\0dataWindow\0box2i\0"s + little_endian_bytes(16) + little_endian_bytes(0) +
         little_endian_bytes(0) + little_endian_bytes(right) + little_endian_bytes(bottom);
}

}  // namespace plumb
