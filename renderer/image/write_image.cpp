#include "renderer/image/write_image.h"

#include <vector>

#include "renderer/image/picture_module.h"
#include "renderer/image/png_file.h"
#include "renderer/image/staged_file.h"
#include "renderer/math/input_error.h"
#include "renderer/math/nearest_name.h"

namespace plumb {
namespace {

bool is_exr(const std::filesystem::path& file) { return equal_ignoring_case(file.extension().string(), ".exr"); }
bool is_png(const std::filesystem::path& file) { return equal_ignoring_case(file.extension().string(), ".png"); }

}  // namespace

void write_image(const Image& image, const std::filesystem::path& file) {
  require_image_writable(file);
  if (is_png(file)) {
    write_png(levels_of(image), image.width(), image.height(), file);
    return;
  }
  std::vector<float> samples;
  samples.reserve(image.pixels().size() * 3);
  for (const Color& c : image.pixels()) {
    samples.insert(samples.end(), {static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b)});
  }
  std::string bytes;
  const std::string fault = picture_module().encode_exr(samples, image.width(), image.height(), bytes);
  if (!fault.empty()) throw InputError({file.string()}, "cannot encode the picture: " + fault);
  write_file_staged(file, bytes);
}

void write_png(std::span<const std::uint8_t> levels, int width, int height, const std::filesystem::path& file) {
  write_file_staged(file, encode_png(levels, width, height));
}

void require_image_writable(const std::filesystem::path& file) {
  if (!is_png(file) && !is_exr(file)) {
    throw InputError({file.string()},
                     "unknown kind of picture '" + file.extension().string() + "', expected .png or .exr");
  }
  require_writable(file);
}

}  // namespace plumb
