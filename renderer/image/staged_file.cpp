#include "renderer/image/staged_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "renderer/math/input_error.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

}  // namespace

void write_file_staged(const fs::path& file, std::string_view bytes) {
  require_writable(file);
  fs::path partial = file;
  partial += ".partial";
  {
    errno = 0;
    std::ofstream stream(partial, std::ios::binary | std::ios::trunc);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    stream.close();
    if (!stream) {
      const std::string reason = std::strerror(errno);
      std::error_code ignored;
      fs::remove(partial, ignored);
      throw InputError({file.string()}, "cannot write the file: " + reason);
    }
  }
  std::error_code error;
  fs::rename(partial, file, error);
  if (error) {
    std::error_code ignored;
    fs::remove(partial, ignored);
    throw InputError({file.string()}, "cannot write the file: " + error.message());
  }
}

void require_writable(const fs::path& file) {
  std::error_code error;
  if (file.filename().empty() || fs::is_directory(file, error)) {
    throw InputError({file.string()}, "cannot write the file: this is a folder, expected the name of a file");
  }
  const fs::path folder = folder_of(file);
  if (!fs::is_directory(folder, error)) {
    throw InputError({file.string()}, "cannot write the file: the folder '" + folder.string() + "' does not exist");
  }
  if (::access(folder.c_str(), W_OK) != 0) {
    throw InputError({file.string()}, std::string("cannot write the file: ") + std::strerror(errno));
  }
}

}  // namespace plumb
