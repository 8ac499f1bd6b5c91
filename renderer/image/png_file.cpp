#include "renderer/image/png_file.h"

#include <png.h>

#include <array>
#include <cerrno>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <vector>

#include "renderer/math/input_error.h"

namespace plumb {
namespace {

/// libpng leaves a failing call by longjmp. So between setjmp and its calls there are no objects with destructors, and
/// what must outlive the jump is held here, outside of the functions that it leaves.
struct PngState {
  png_structp png = nullptr;
  png_infop info = nullptr;
  char message[200] = "";
};

void on_error(png_structp png, png_const_charp message) {
  auto* state = static_cast<PngState*>(png_get_error_ptr(png));
  std::snprintf(state->message, sizeof state->message, "%s", message);
  png_longjmp(png, 1);
}

/// What libpng can live with is no business of who looks at the pixels.
void on_warning(png_structp, png_const_charp) {}

/// libpng's state for reading, freed with it.
class PngReader : public PngState {
 public:
  PngReader() {
    png = png_create_read_struct(PNG_LIBPNG_VER_STRING, static_cast<PngState*>(this), on_error, on_warning);
    if (png != nullptr) info = png_create_info_struct(png);
    if (info == nullptr) throw std::runtime_error("libpng cannot be used: " + std::string(message));
  }
  ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
};

class PngWriter : public PngState {
 public:
  PngWriter() {
    png = png_create_write_struct(PNG_LIBPNG_VER_STRING, static_cast<PngState*>(this), on_error, on_warning);
    if (png != nullptr) info = png_create_info_struct(png);
    if (info == nullptr) throw std::runtime_error("libpng cannot be used: " + std::string(message));
  }
  ~PngWriter() { png_destroy_write_struct(&png, &info); }
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;
};

/// Everything before the rows. Grey of few bits becomes 8 bits, a palette its colours, a transparent colour an alpha
/// channel; 16-bit samples come in the machine's order. Colour profiles and gamma are not applied: levels are levels.
bool read_until_rows(PngState& state, std::FILE* file) {
  if (setjmp(png_jmpbuf(state.png)) != 0) return false;
  png_init_io(state.png, file);
  png_read_info(state.png, state.info);
  png_set_expand(state.png);
  png_set_swap(state.png);
  png_set_interlace_handling(state.png);
  png_read_update_info(state.png, state.info);
  return true;
}

bool read_rows(PngState& state, png_bytepp rows) {
  if (setjmp(png_jmpbuf(state.png)) != 0) return false;
  png_read_image(state.png, rows);
  png_read_end(state.png, nullptr);  // a file that was cut off behind the last row is damaged, too
  return true;
}

void append_bytes(png_structp png, png_bytep bytes, std::size_t count) {
  bool appended = true;
  try {
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), count);
  } catch (const std::exception&) {
    appended = false;  // no exception may pass through libpng, and no jump leave its handler
  }
  if (!appended) png_error(png, "memory is short");
}

bool write_all(PngState& state, std::string& bytes, png_bytepp rows, int width, int height) {
  if (setjmp(png_jmpbuf(state.png)) != 0) return false;
  png_set_write_fn(state.png, &bytes, append_bytes, nullptr);
  png_set_IHDR(state.png, state.info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), 8,
               PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_rows(state.png, state.info, rows);
  png_write_png(state.png, state.info, PNG_TRANSFORM_IDENTITY, nullptr);
  return true;
}

/// Levels from 0 to 255 of each pixel's first three channels, or of its one grey channel three times.
template <class Sample>
void take_levels(const std::vector<png_byte>& bytes, std::size_t channels, float unit, Picture& picture) {
  const bool has_alpha = channels % 2 == 0;
  const std::size_t step = channels >= 3 ? 1 : 0, pixels = bytes.size() / (channels * sizeof(Sample));
  picture.samples.reserve(3 * pixels);
  std::array<Sample, 4> pixel{};
  for (std::size_t i = 0; i < pixels; ++i) {
    std::memcpy(pixel.data(), bytes.data() + i * channels * sizeof(Sample), channels * sizeof(Sample));
    for (std::size_t k = 0; k < 3; ++k) picture.samples.push_back(static_cast<float>(pixel[k * step]) / unit);
    if (has_alpha && static_cast<float>(pixel[channels - 1]) / unit < 255) picture.transparent = true;
  }
}

}  // namespace

Picture decode_png(const std::filesystem::path& file, const PictureHeader& header) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(file.c_str(), "rb"), std::fclose);
  if (!stream) throw InputError({file.string()}, std::string("cannot open the picture: ") + std::strerror(errno));
  PngReader reader;
  if (!read_until_rows(reader, stream.get())) throw BadPicture("it cannot be decoded: " + std::string(reader.message));
  const std::size_t channels = png_get_channels(reader.png, reader.info);
  const int depth = png_get_bit_depth(reader.png, reader.info);
  if (png_get_image_width(reader.png, reader.info) != static_cast<png_uint_32>(header.width) ||
      png_get_image_height(reader.png, reader.info) != static_cast<png_uint_32>(header.height) || channels < 1 ||
      channels > 4 || (depth != 8 && depth != 16)) {
    throw BadPicture("its content does not fit its header");
  }
  const std::size_t row_bytes = static_cast<std::size_t>(header.width) * channels * static_cast<std::size_t>(depth / 8);
  std::vector<png_byte> bytes(row_bytes * static_cast<std::size_t>(header.height));
  std::vector<png_bytep> rows;
  for (int y = 0; y < header.height; ++y) rows.push_back(bytes.data() + static_cast<std::size_t>(y) * row_bytes);
  if (!read_rows(reader, rows.data())) throw BadPicture("it is damaged: " + std::string(reader.message));
  Picture picture{PictureFormat::png, header.width, header.height, {}, false};
  // 16 bits over 257 are levels: 65535 / 257 = 255.
  if (depth == 8) {
    take_levels<std::uint8_t>(bytes, channels, 1, picture);
  } else {
    take_levels<std::uint16_t>(bytes, channels, 257, picture);
  }
  return picture;
}

std::string encode_png(std::span<const std::uint8_t> levels, int width, int height) {
  PngWriter writer;
  std::string bytes;
  std::vector<png_bytep> rows;
  // libpng takes rows that are not const and does not write to them.
  for (int y = 0; y < height; ++y) {
    rows.push_back(const_cast<png_bytep>(levels.data()) +
                   3 * static_cast<std::size_t>(y) * static_cast<std::size_t>(width));
  }
  if (!write_all(writer, bytes, rows.data(), width, height)) throw std::runtime_error(writer.message);
  return bytes;
}

}  // namespace plumb
