#include "renderer/image/write_image.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <memory>
#include <vector>

#include "renderer/image/staged_file.h"
#include "renderer/math/input_error.h"
#include "renderer/math/nearest_name.h"

namespace plumb {
namespace {

/// Encodes in memory, so that nothing half-written ever has the file's name.
void encode_and_write(const char* plugin, OIIO::TypeDesc type, const void* samples, int width, int height,
                      const std::filesystem::path& file) {
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(plugin);
  if (!output) throw std::runtime_error(std::string("OpenImageIO has no writer for ") + plugin);
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const OIIO::ImageSpec spec(width, height, 3, type);
  if (!output->set_ioproxy(&memory) || !output->open(file.filename().string(), spec) ||
      !output->write_image(type, samples) || !output->close()) {
    throw InputError({file.string()}, "cannot encode the picture: " + output->geterror());
  }
  write_file_staged(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

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
  encode_and_write("openexr", OIIO::TypeDesc::FLOAT, samples.data(), image.width(), image.height(), file);
}

void write_png(std::span<const std::uint8_t> levels, int width, int height, const std::filesystem::path& file) {
  encode_and_write("png", OIIO::TypeDesc::UINT8, levels.data(), width, height, file);
}

void require_image_writable(const std::filesystem::path& file) {
  if (!is_png(file) && !is_exr(file)) {
    throw InputError({file.string()},
                     "unknown kind of picture '" + file.extension().string() + "', expected .png or .exr");
  }
  require_writable(file);
}

}  // namespace plumb
