// The module of the formats that go through OpenImageIO; see PictureModule.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "renderer/image/picture_module.h"

namespace plumb {
namespace {

/// Where red, green, blue and alpha stand among a file's channels; alpha is -1 without one.
struct ChannelOrder {
  std::array<int, 3> rgb{0, 0, 0};
  int alpha = -1;
};

ChannelOrder channel_order(const OIIO::ImageSpec& spec) {
  ChannelOrder order;
  if (spec.nchannels >= 3) order.rgb = {0, 1, 2};
  const auto index = [&](const char* name) { return spec.channelindex(name); };
  if (index("R") >= 0 && index("G") >= 0 && index("B") >= 0) order.rgb = {index("R"), index("G"), index("B")};
  order.alpha = spec.alpha_channel;
  return order;
}

/// What the library says, without the folder that the file lies in: such texts are kept with results.
std::string said(const OIIO::ImageInput& input, const std::filesystem::path& file) {
  std::string text = input.geterror();
  text = text.substr(0, text.find('\n'));  // the library says the same again on further lines
  const std::string path = file.string();
  for (std::size_t at = text.find(path); at != std::string::npos; at = text.find(path, at))
    text.replace(at, path.size(), file.filename().string());
  return text;
}

/// Samples of every channel, unsigned integers brought to levels 0 to 255 and floats left alone. False if the file is
/// damaged.
bool read_channels(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, PictureFormat format,
                   std::vector<float>& samples) {
  const std::size_t count = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height) *
                            static_cast<std::size_t>(spec.nchannels);
  const auto read = [&](OIIO::TypeDesc type, void* to) { return input.read_image(0, 0, 0, spec.nchannels, type, to); };
  samples.resize(count);
  if (format == PictureFormat::exr) return read(OIIO::TypeDesc::FLOAT, samples.data());
  if (spec.format == OIIO::TypeDesc::UINT8) {
    std::vector<std::uint8_t> levels(count);
    if (!read(OIIO::TypeDesc::UINT8, levels.data())) return false;
    std::copy(levels.begin(), levels.end(), samples.begin());
    return true;
  }
  std::vector<std::uint16_t> levels(count);
  if (!read(OIIO::TypeDesc::UINT16, levels.data())) return false;
  std::transform(levels.begin(), levels.end(), samples.begin(),
                 [](std::uint16_t v) { return static_cast<float>(v) / 257.0F; });
  return true;
}

/// An EXR file may name thousands of channels, each of which would take the picture's size in memory.
constexpr int kMostChannels = 16;

std::string decode(const std::filesystem::path& file, const PictureHeader& header, Picture& picture) {
  // The plug-in is named, because by default files are recognised by content whatever their name.
  const char* plugin = header.format == PictureFormat::exr ? "openexr" : "pnm";
  const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create(plugin);
  if (!input) return std::string("OpenImageIO has no reader for ") + plugin;
  OIIO::ImageSpec spec;
  OIIO::ImageSpec wish;
  wish.attribute("oiio:UnassociatedAlpha", 1);
  if (!input->open(file.string(), spec, wish)) return "it cannot be decoded: " + said(*input, file);
  if (spec.width != header.width || spec.height != header.height || spec.depth > 1 || spec.nchannels < 1 ||
      spec.nchannels > kMostChannels || spec.deep) {
    return "its content does not fit its header";
  }
  picture = {header.format, header.width, header.height, {}, false};
  std::vector<float> channels;
  if (!read_channels(*input, spec, header.format, channels)) return "it is damaged: " + said(*input, file);
  const ChannelOrder order = channel_order(spec);
  const float opaque = picture.is_linear() ? 1.0F : 255.0F;
  const std::size_t stride = static_cast<std::size_t>(spec.nchannels);
  picture.samples.reserve(channels.size() / stride * 3);
  for (std::size_t at = 0; at < channels.size(); at += stride) {
    for (const int channel : order.rgb) picture.samples.push_back(channels[at + static_cast<std::size_t>(channel)]);
    if (order.alpha >= 0 && channels[at + static_cast<std::size_t>(order.alpha)] < opaque) picture.transparent = true;
  }
  return "";
}

/// Encodes in memory, so that nothing half-written ever has the file's name.
std::string encode_exr(std::span<const float> samples, int width, int height, std::string& bytes) {
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create("openexr");
  if (!output) return "OpenImageIO has no writer for openexr";
  std::vector<unsigned char> encoded;
  OIIO::Filesystem::IOVecOutput memory(encoded);
  const OIIO::ImageSpec spec(width, height, 3, OIIO::TypeDesc::FLOAT);
  if (!output->set_ioproxy(&memory) || !output->open("picture.exr", spec) ||
      !output->write_image(OIIO::TypeDesc::FLOAT, samples.data()) || !output->close()) {
    return output->geterror();
  }
  bytes.assign(encoded.begin(), encoded.end());
  return "";
}

}  // namespace
}  // namespace plumb

extern "C" [[gnu::visibility("default")]] const plumb::PictureModule plumb_picture_module;
const plumb::PictureModule plumb_picture_module = {plumb::decode, plumb::encode_exr};
