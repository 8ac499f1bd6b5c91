#include "conformance/growth/growth_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "conformance/families/random.h"
#include "renderer/film/render.h"
#include "renderer/image/image.h"
#include "renderer/image/picture_header.h"
#include "renderer/image/read_picture.h"

namespace plumb {
namespace {

constexpr int kTile = 16;
constexpr int kTiles = 16;

CheckResult fault(const std::string& cause, const std::string& summary, const std::string& advice) {
  CheckResult result;
  result.verdict = Verdict::fail;
  result.cause = cause;
  result.summary = summary;
  result.advice = advice;
  return result;
}

/// In levels; NaN counts as different.
bool differs(const float* found, const Color& expected, bool is_linear, double levels) {
  const double tolerance = is_linear ? levels / 255 : levels;
  for (const double linear : {expected.r, expected.g, expected.b}) {
    const double right = is_linear ? linear : static_cast<double>(level_of(linear));
    if (!(std::abs(static_cast<double>(*found++) - right) <= tolerance)) return true;
  }
  return false;
}

std::vector<PixelRect> tiles_of(int width, int height, std::uint64_t seed) {
  if (width * height <= kTiles * kTile * kTile) return {{0, 0, width, height}};
  Random random(seed, "growth-tiles", 0);
  std::vector<PixelRect> tiles;
  const int tile_width = std::min(kTile, width);
  const int tile_height = std::min(kTile * kTile / tile_width, height);
  for (int i = 0; i < kTiles; ++i) {
    const int x = random.integer(0, width - tile_width), y = random.integer(0, height - tile_height);
    tiles.push_back({x, y, tile_width, tile_height});
  }
  return tiles;
}

}  // namespace

CheckResult check_growth_picture(const std::filesystem::path& file, const Scene& scene,
                                 const GrowthTolerance& tolerance, std::uint64_t seed) {
  const Size2 size = scene.image_size();
  Picture picture;
  try {
    const PictureHeader header = read_picture_header(file);
    if (header.width != size.width || header.height != size.height)
      return fault(
          "wrong_size",
          fmt::format("the picture is {}x{}, expected {}x{}", header.width, header.height, size.width, size.height),
          "write the picture in the size that the scene asks for");
    picture = read_picture(file);
  } catch (const BadPicture& error) {
    return fault("bad_picture", std::string("the picture cannot be used: ") + error.what(),
                 "write a valid picture file of the kind its name says");
  }
  std::int64_t pixels = 0, wrong = 0;
  for (const PixelRect& tile : tiles_of(size.width, size.height, seed)) {
    const Image image = render(scene, {.threads = 1, .crop = tile, .progress = nullptr}).image;
    for (int y = 0; y < tile.height; ++y)
      for (int x = 0; x < tile.width; ++x, ++pixels)
        if (differs(picture.pixel(tile.x + x, tile.y + y), image.at(x, y), picture.is_linear(), tolerance.levels))
          ++wrong;
  }
  if (static_cast<double>(wrong) > tolerance.share * static_cast<double>(pixels))
    return fault("different",
                 fmt::format("the picture of {}x{} is wrong: only a program that renders all of it is timed",
                             size.width, size.height),
                 "render the scenes of smooth meshes right first, in every size, each time anew");
  CheckResult result;
  result.verdict = Verdict::pass;
  return result;
}

}  // namespace plumb
