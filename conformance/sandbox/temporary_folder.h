#pragma once

#include <stdlib.h>

#include <cerrno>
#include <filesystem>
#include <string>
#include <system_error>

namespace plumb {

/// A new folder that nobody else can name beforehand, `/tmp/plumb-WHAT-XXXXXX`, and that is gone with all in it when
/// this is. Throws std::system_error where it cannot be made.
class TemporaryFolder {
 public:
  explicit TemporaryFolder(const std::string& what) {
    std::string name = (std::filesystem::temp_directory_path() / ("plumb-" + what + "-XXXXXX")).string();
    if (!::mkdtemp(name.data())) throw std::system_error(errno, std::generic_category(), "cannot make " + name);
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace plumb
