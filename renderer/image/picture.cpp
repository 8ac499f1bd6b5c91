#include "renderer/image/picture.h"

namespace plumb {

std::string to_string(PictureFormat format) {
  switch (format) {
    case PictureFormat::png:
      return "PNG";
    case PictureFormat::exr:
      return "EXR";
    case PictureFormat::ppm:
      return "PPM";
  }
  throw std::logic_error("unknown picture format");
}

}  // namespace plumb
