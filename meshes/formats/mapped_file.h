#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace plumb {

/// The content of a regular file, mapped into memory, so that it is read as it is walked through and no copy of it is
/// made; where its file system cannot map it, read. Who changes the file meanwhile changes the bytes, and who shortens
/// it ends the program with SIGBUS.
class MappedFile {
 public:
  /// Throws InputError as file_bytes does.
  explicit MappedFile(const std::filesystem::path& file);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  std::string_view bytes() const { return address_ != nullptr ? std::string_view(address_, size_) : copy_; }

 private:
  const char* address_ = nullptr;
  std::size_t size_ = 0;
  std::string copy_;
};

}  // namespace plumb
