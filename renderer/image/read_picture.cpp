#include "renderer/image/read_picture.h"

#include "renderer/image/picture_header.h"
#include "renderer/image/picture_module.h"
#include "renderer/image/png_file.h"

namespace plumb {

Picture read_picture(const std::filesystem::path& file) {
  const PictureHeader header = read_picture_header(file);
  if (header.format == PictureFormat::png) return decode_png(file, header);
  Picture picture;
  const std::string defect = picture_module().decode(file, header, picture);
  if (!defect.empty()) throw BadPicture(defect);
  return picture;
}

}  // namespace plumb
