#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace plumb {

/// The picture formats that are read. A file's content must be of the format that its name ends in.
enum class PictureFormat { png, exr, ppm };

std::string to_string(PictureFormat format);

/// A decoded picture file. Samples are three floats a pixel, rows from the top: 8-bit levels (0 to 255) for
/// PNG and PPM, where 16-bit files give fractions; linear values, which need not be finite, for EXR.
struct Picture {
  PictureFormat format = PictureFormat::png;
  int width = 0;
  int height = 0;
  std::vector<float> samples;
  /// Whether some pixel has an alpha below full.
  bool transparent = false;

  bool is_linear() const { return format == PictureFormat::exr; }
  const float* pixel(int x, int y) const {
    return samples.data() +
           3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
  }
};

/// A file that exists but is not a valid picture: the fault of whoever wrote it.
class BadPicture : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace plumb
