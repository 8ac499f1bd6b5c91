#include "meshes/formats/file_bytes.h"

#include <fstream>
#include <system_error>

#include "renderer/math/input_error.h"

namespace plumb {

void require_regular_file(const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) throw InputError({file.string()}, "no such file; expected a mesh file");
  if (!std::filesystem::is_regular_file(status)) {
    throw InputError({file.string()}, "not a regular file; expected a mesh file");
  }
}

std::string file_bytes(const std::filesystem::path& file) {
  require_regular_file(file);
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  std::ifstream in(file, std::ios::binary);
  if (error || !in) throw InputError({file.string()}, "cannot be opened; expected a readable mesh file");
  std::string bytes(size, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(size));
  if (static_cast<std::uintmax_t>(in.gcount()) != size) {
    throw InputError({file.string()}, "cannot be read to its end; expected " + std::to_string(size) + " bytes");
  }
  return bytes;
}

std::string lower_case_ending(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  for (char& c : ending) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return ending;
}

}  // namespace plumb
