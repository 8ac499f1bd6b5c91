#include "renderer/image/staged_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

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
  // A leftover of that name goes; the new one is made only if it is not there, so that no link is followed.
  std::error_code ignored;
  fs::remove(partial, ignored);
  errno = 0;
  std::FILE* stream = std::fopen(partial.c_str(), "wbx");
  bool written = stream && std::fwrite(bytes.data(), 1, bytes.size(), stream) == bytes.size();
  if (stream && std::fclose(stream) != 0) written = false;
  if (!written) {
    const std::string reason = std::strerror(errno);
    fs::remove(partial, ignored);
    throw InputError({file.string()}, "cannot write the file: " + reason);
  }
  std::error_code error;
  fs::rename(partial, file, error);
  if (error) {
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
